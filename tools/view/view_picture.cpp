#include "view_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "errors.h"
#include "stage_pictures.h"

namespace runmark::cli {
namespace {

constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double letters = 0.5;
constexpr int line_height = 22;
constexpr int least_width = 640;
const cv::Scalar bar_colour(40, 40, 40);
const cv::Scalar ink(235, 235, 235);

}  // namespace

cv::Mat draw_stage(const Frame& frame, Stage stage, const Options& options,
                   const std::vector<Dictionary>& dictionaries) {
  const std::vector<StagePicture> pictures = draw_stages(trace_stages(frame.pixels, options, dictionaries));
  // Named by their numbers; full size comes before the half sizes.
  return std::ranges::find_if(
             pictures, [stage](const StagePicture& p) { return p.name[0] == static_cast<char>(stage); })
      ->picture;
}

cv::Mat compose(const cv::Mat& picture, const std::string& status, std::span<const std::string> lines) {
  const int zoom = (least_width + picture.cols - 1) / picture.cols;
  const cv::Size size(picture.cols * zoom, picture.rows * zoom);
  cv::Mat shown(size.height + line_height + 4, size.width, CV_8UC3, bar_colour);
  cv::Mat above = shown(cv::Rect(cv::Point(), size));
  cv::resize(picture, above, size, 0, 0, cv::INTER_NEAREST);
  cv::putText(shown, status, {8, size.height + 18}, font, letters, ink, 1, cv::LINE_AA);
  if (lines.empty()) return shown;
  const cv::Rect box =
      cv::Rect(8, 8, 500, line_height * static_cast<int>(lines.size()) + 12) & cv::Rect(cv::Point(), size);
  above(box) = above(box) / 4;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const cv::Point at(18, 8 + line_height * static_cast<int>(i + 1));
    cv::putText(above, lines[i], at, font, letters, ink, 1, cv::LINE_AA);
  }
  return shown;
}

}  // namespace runmark::cli
