#include "coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "errors.h"
#include "output_file.h"

namespace runmark::cli {
namespace {

constexpr std::array<std::string_view, 9> ninths{
    "upper left", "top", "upper right", "left", "middle", "right", "lower left", "bottom", "lower right"};

int part(double place, int side, int parts) {
  return std::clamp(static_cast<int>((place + 0.5) / side * parts), 0, parts - 1);
}

/// Calls `use(view, corner)` for each that was used.
template <class Use>
void for_each_corner(const std::vector<CalibrationView>& views, const Calibration& calibration, Use use) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (calibration.views[i].outlier) continue;
    for (std::size_t k = 0; k < views[i].image.size(); ++k) {
      if (calibration.views[i].used[k]) use(i, views[i].image[k]);
    }
  }
}

/// Far apart for neighbouring views.
cv::Scalar colour_of(std::size_t view) {
  cv::Mat hsv(1, 1, CV_8UC3, cv::Scalar(static_cast<double>(view * 67 % 180), 220, 210));
  cv::cvtColor(hsv, hsv, cv::COLOR_HSV2BGR);
  const auto& c = hsv.at<cv::Vec3b>(0, 0);
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

}  // namespace

Coverage::Coverage(const std::vector<CalibrationView>& views, const Calibration& calibration)
    : counts_(static_cast<std::size_t>(columns * rows)) {
  const Camera& camera = calibration.camera;
  std::array<int, 9> of_ninth{};
  for_each_corner(views, calibration, [&](std::size_t, Point p) {
    ++counts_[static_cast<std::size_t>(part(p.y, camera.height, rows) * columns +
                                       part(p.x, camera.width, columns))];
    ++of_ninth[static_cast<std::size_t>(part(p.y, camera.height, 3) * 3 + part(p.x, camera.width, 3))];
  });
  for (std::size_t i = 0; i < ninths.size(); ++i) {
    if (of_ninth[i] == 0) empty_.push_back(ninths[i]);
  }
}

int Coverage::parts_reached() const {
  return static_cast<int>(std::ranges::count_if(counts_, [](int n) { return n > 0; }));
}

void write_coverage_picture(const std::string& path, const std::vector<CalibrationView>& views,
                            const Calibration& calibration) {
  const Camera& camera = calibration.camera;
  cv::Mat picture(camera.height, camera.width, CV_8UC3, cv::Scalar(255, 255, 255));
  const Coverage coverage(views, calibration);
  for (int row = 0; row < Coverage::rows; ++row) {
    for (int column = 0; column < Coverage::columns; ++column) {
      const cv::Point from(column * camera.width / Coverage::columns, row * camera.height / Coverage::rows);
      const cv::Point to((column + 1) * camera.width / Coverage::columns,
                         (row + 1) * camera.height / Coverage::rows);
      const double share = std::min(1.0, coverage.corners(column, row) / 20.0);
      const bool none = coverage.corners(column, row) == 0;
      cv::rectangle(
          picture, from, to,
          none ? cv::Scalar(225, 225, 255) : cv::Scalar(255 - 70 * share, 255 - 15 * share, 255 - 70 * share),
          cv::FILLED);
      cv::rectangle(picture, from, to, cv::Scalar(225, 225, 225));
    }
  }
  const int radius = std::max(2, camera.width / 320);
  for_each_corner(views, calibration, [&](std::size_t view, Point p) {
    constexpr int bits = 4;
    cv::circle(picture,
               cv::Point(static_cast<int>(std::lround(p.x * 16)), static_cast<int>(std::lround(p.y * 16))),
               radius << bits, colour_of(view), cv::FILLED, cv::LINE_AA, bits);
  });
  std::vector<std::uint8_t> bytes;
  try {
    cv::imencode(std::filesystem::path(path).extension().string(), picture, bytes);
  } catch (const cv::Exception&) {
    throw UserError(path + ": is no picture's name that can be written (.png, .jpg)");
  }
  write_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace runmark::cli
