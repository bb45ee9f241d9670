#include "bench/false_alarms/frames.h"

#include <array>
#include <opencv2/imgproc.hpp>
#include <string>

#include "render/rng.h"

namespace runmark::bench {
namespace {

using render::Rng;
constexpr int width = 320;
constexpr int height = 240;

int whole(Rng& rng, int low, int high) { return low + rng.below(high - low + 1); }

cv::Mat noise(Rng& rng) {
  // Blocks of one grey make cells; one pixel each is white noise.
  const int block = rng.chance(0.3) ? 1 : whole(rng, 2, 12);
  const bool two_levels = rng.chance(0.6);
  cv::Mat small(height / block + 1, width / block + 1, CV_8UC1);
  for (auto& value : cv::Mat_<std::uint8_t>(small)) {
    value = static_cast<std::uint8_t>(two_levels ? 255 * rng.below(2) : rng.below(256));
  }
  cv::Mat large;
  const bool smooth = rng.chance(0.4);
  cv::resize(small, large, {}, block, block, smooth ? cv::INTER_CUBIC : cv::INTER_NEAREST);
  return large(cv::Rect(0, 0, width, height)).clone();
}

cv::Mat rectangles(Rng& rng) {
  cv::Mat frame(height, width, CV_8UC1, cv::Scalar(rng.below(256)));
  for (int n = whole(rng, 20, 300); n > 0; --n) {
    const cv::RotatedRect box(
        cv::Point2f(static_cast<float>(rng.uniform(0, width)), static_cast<float>(rng.uniform(0, height))),
        cv::Size2f(static_cast<float>(rng.uniform(3, 60)), static_cast<float>(rng.uniform(3, 60))),
        static_cast<float>(rng.uniform(0, 90)));
    std::array<cv::Point2f, 4> corners;
    box.points(corners.data());
    const std::array<cv::Point, 4> whole_pixels{corners[0], corners[1], corners[2], corners[3]};
    cv::fillConvexPoly(frame, whole_pixels, cv::Scalar(rng.below(256)));
  }
  return frame;
}

cv::Mat pattern(Rng& rng) {
  cv::Mat frame(height, width, CV_8UC1);
  const double angle = rng.uniform(0, 3.14159);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double pitch = rng.uniform(4, 50);
  const double stretch = rng.uniform(0.4, 2.5);
  const double joint = rng.uniform(0.03, 0.3);
  const int kind = rng.below(3);
  const std::uint64_t salt = rng.next();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (c * x + s * y) / pitch;
      double v = (c * y - s * x) / pitch * stretch;
      const auto row = static_cast<std::int64_t>(std::floor(v));
      double shade = 0;
      if (kind == 0) {  // chequers
        shade = ((static_cast<std::int64_t>(std::floor(u)) + row) & 1) != 0 ? 1 : 0;
      } else if (kind == 1) {  // bricks, each of its own shade
        const double along = u + 0.5 * static_cast<double>(row & 1);
        const auto column = static_cast<std::int64_t>(std::floor(along));
        v -= static_cast<double>(row);
        const bool mortar = along - static_cast<double>(column) < joint || v < joint;
        const std::uint64_t brick = render::mix(
            salt ^ render::mix(static_cast<std::uint64_t>(row) * 8191U + static_cast<std::uint64_t>(column)));
        shade = mortar ? 1 : static_cast<double>(brick % 256) / 300;
      } else {  // crossing waves
        shade = 0.5 + 0.25 * std::sin(6.28 * u) + 0.25 * std::sin(6.28 * v + 2 * std::sin(3 * u));
      }
      frame.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(20 + 215 * shade);
    }
  }
  return frame;
}

cv::Mat text(Rng& rng) {
  const bool dark_on_light = rng.chance(0.7);
  cv::Mat page(2 * height, 2 * width, CV_8UC1, cv::Scalar(dark_on_light ? 235 : 25));
  const int font = rng.below(8);
  const double size = rng.uniform(0.3, 2.2);
  const int thick = whole(rng, 1, 1 + static_cast<int>(3 * size));
  for (int y = 10; y < page.rows + 20; y += 8 + static_cast<int>(26 * size)) {
    std::string line;
    for (int i = 0; i < 60; ++i) line += static_cast<char>(whole(rng, 33, 126));
    cv::putText(page, line, {-whole(rng, 0, 20), y}, font, size, cv::Scalar(dark_on_light ? 25 : 235), thick,
                rng.chance(0.5) ? cv::LINE_AA : cv::LINE_8);
  }
  const double angle = rng.chance(0.5) ? rng.uniform(-10, 10) : rng.uniform(0, 360);
  cv::Mat turned;
  cv::warpAffine(page, turned, cv::getRotationMatrix2D({width, height}, angle, 1), page.size(),
                 cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return turned(cv::Rect(width / 2, height / 2, width, height)).clone();
}

/// The camera: contrast, blur and noise.
void photograph(cv::Mat& frame, Rng& rng) {
  if (rng.chance(0.6)) cv::GaussianBlur(frame, frame, {}, rng.uniform(0.3, 1.5));
  frame.convertTo(frame, CV_8UC1, rng.uniform(0.3, 1), rng.uniform(0, 40));
  const double grain = rng.uniform(0, 6);
  for (auto& value : cv::Mat_<std::uint8_t>(frame)) {
    const double bell = rng.uniform(-1, 1) + rng.uniform(-1, 1) + rng.uniform(-1, 1);
    value = cv::saturate_cast<std::uint8_t>(value + grain * bell);
  }
}

}  // namespace

std::string_view name_of(FrameKind kind) {
  constexpr std::array<std::string_view, frame_kinds> names{"noise", "texture", "text"};
  return names[static_cast<std::size_t>(kind)];
}

cv::Mat marker_free_frame(int index) {
  Rng rng(render::mix(0xFA15E + static_cast<std::uint64_t>(index)));
  const FrameKind kind = kind_of(index);
  cv::Mat frame = kind == FrameKind::noise  ? noise(rng)
                  : kind == FrameKind::text ? text(rng)
                  : rng.chance(0.5)         ? rectangles(rng)
                                            : pattern(rng);
  photograph(frame, rng);
  return frame;
}

}  // namespace runmark::bench
