#include "bench/side_by_side/thumbnail.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string_view>
#include <vector>

namespace runmark::bench {
namespace {

constexpr int thumbnail_side = 128;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) group = group << 8 | (j < n ? bytes[i + j] : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += j <= n ? digits[group >> (18 - 6 * j) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string thumbnail(const cv::Mat& grey, const Corners& corners, const cv::Scalar& colour) {
  const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x, corners[3].x});
  const auto [upper, lower] = std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
  const double half = 0.8 * std::max({right - left, lower - upper, 12.0});
  const Point middle = {(left + right) / 2, (upper + lower) / 2};
  const cv::Rect wanted(static_cast<int>(middle.x - half), static_cast<int>(middle.y - half),
                        static_cast<int>(2 * half) + 1, static_cast<int>(2 * half) + 1);
  const cv::Rect inside = wanted & cv::Rect(0, 0, grey.cols, grey.rows);
  if (inside.empty()) return {};
  const double scale = static_cast<double>(thumbnail_side) / std::max(inside.width, inside.height);
  cv::Mat picture;
  cv::resize(grey(inside), picture, {}, scale, scale, scale > 1 ? cv::INTER_NEAREST : cv::INTER_AREA);
  cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
  std::vector<cv::Point> outline;
  for (const Point& p : corners) {
    outline.emplace_back(static_cast<int>((p.x + 0.5 - inside.x) * scale),
                         static_cast<int>((p.y + 0.5 - inside.y) * scale));
  }
  cv::polylines(picture, outline, true, colour, 1, cv::LINE_AA);
  cv::circle(picture, outline[0], 3, colour, cv::FILLED, cv::LINE_AA);
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 80})) return {};
  return "data:image/jpeg;base64," + base64(bytes);
}

}  // namespace runmark::bench
