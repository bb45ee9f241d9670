#include "annotate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

namespace runmark::cli {
namespace {

// Bright strokes with a dark rim stand out from any background.
const cv::Scalar outline_colour(80, 255, 60);
const cv::Scalar inverted_colour(255, 220, 40);
const cv::Scalar first_corner_colour(60, 60, 255);
const cv::Scalar letter_colour(255, 255, 255);
const cv::Scalar rim_colour(0, 0, 0);

constexpr int fraction_bits = 4;
constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double font_height = 21;  // of a capital at scale 1

cv::Point fixed_point(double x, double y) {
  constexpr double one = 1 << fraction_bits;
  return {static_cast<int>(std::lround(x * one)), static_cast<int>(std::lround(y * one))};
}

double side_of(const Marker& marker) {
  double round = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& a = marker.corners[i];
    const Point& b = marker.corners[(i + 1) % 4];
    round += std::hypot(b.x - a.x, b.y - a.y);
  }
  return round / 4;
}

void draw_outline(cv::Mat& picture, const Marker& marker, int width) {
  std::array<cv::Point, 4> corners;
  std::ranges::transform(marker.corners, corners.begin(), [](Point p) { return fixed_point(p.x, p.y); });
  const auto draw = [&](const cv::Scalar& colour, int stroke) {
    const cv::Point* points = corners.data();
    const int count = 4;
    cv::polylines(picture, &points, &count, 1, true, colour, stroke, cv::LINE_AA, fraction_bits);
  };
  draw(rim_colour, width + 2 * std::max(1, width / 2));
  draw(marker.inverted ? inverted_colour : outline_colour, width);
}

void draw_first_corner(cv::Mat& picture, const Marker& marker, double half) {
  const Point c = marker.corners[0];
  const auto square = [&](double size, const cv::Scalar& colour) {
    const std::array<cv::Point, 4> points{
        fixed_point(c.x - size, c.y - size), fixed_point(c.x + size, c.y - size),
        fixed_point(c.x + size, c.y + size), fixed_point(c.x - size, c.y + size)};
    cv::fillConvexPoly(picture, points.data(), 4, colour, cv::LINE_AA, fraction_bits);
  };
  square(half + 1, rim_colour);
  square(half, first_corner_colour);
}

void draw_id(cv::Mat& picture, const Marker& marker, double side, double unit) {
  const std::string text = std::to_string(marker.id);
  // Inside the marker when it is large enough to be read there, else above it.
  const bool inside = side >= 30 * unit;
  const double height = inside ? std::clamp(side * 0.22, 9 * unit, 24 * unit) : 9 * unit;
  const double scale = height / font_height;
  const int stroke = std::max(1, static_cast<int>(std::lround(height / 9)));
  const cv::Size size = cv::getTextSize(text, font, scale, stroke, nullptr);
  double x = 0;
  double y = 0;
  double top = marker.corners[0].y;
  for (const Point& corner : marker.corners) {
    x += corner.x / 4;
    y += corner.y / 4;
    top = std::min(top, corner.y);
  }
  const double base = inside ? y + size.height / 2.0 : top - 4 * unit;
  const cv::Point at(
      std::clamp(static_cast<int>(x - size.width / 2.0), 2, std::max(2, picture.cols - size.width - 2)),
      std::clamp(static_cast<int>(base), size.height + 2, std::max(size.height + 2, picture.rows - 3)));
  cv::putText(picture, text, at, font, scale, rim_colour, stroke + 2 * std::max(1, stroke), cv::LINE_AA);
  cv::putText(picture, text, at, font, scale, letter_colour, stroke, cv::LINE_AA);
}

}  // namespace

cv::Mat annotate(const cv::Mat& picture, std::span<const Marker> markers) {
  cv::Mat result;
  if (picture.channels() == 1) {
    cv::cvtColor(picture, result, cv::COLOR_GRAY2BGR);
  } else {
    result = picture.clone();
  }
  const double unit = std::max(1.0, std::min(picture.cols, picture.rows) / 600.0);
  for (const Marker& marker : markers) {
    const double side = side_of(marker);
    const int width = std::max(1, static_cast<int>(std::lround(std::min(2 * unit, side / 12))));
    draw_outline(result, marker, width);
    draw_first_corner(result, marker, std::clamp(side / 14, 1.5, 5 * unit));
  }
  for (const Marker& marker : markers) draw_id(result, marker, side_of(marker), unit);
  return result;
}

void draw_axes(cv::Mat& picture, const AxesPicture& axes) {
  const std::array colours{cv::Scalar(60, 60, 255), cv::Scalar(60, 200, 60), cv::Scalar(255, 120, 40)};
  const double unit = std::max(1.0, std::min(picture.cols, picture.rows) / 600.0);
  const int width = static_cast<int>(std::lround(2 * unit));
  // Far outside the picture fixed-point places would run over.
  const auto drawable = [&](Point p) {
    const double most = 4.0 * (picture.cols + picture.rows);
    return std::fabs(p.x) < most && std::fabs(p.y) < most;
  };
  for (std::size_t i = colours.size(); i > 0; --i) {
    if (!drawable(axes[0]) || !drawable(axes[i])) continue;
    const cv::Point from = fixed_point(axes[0].x, axes[0].y);
    const cv::Point to = fixed_point(axes[i].x, axes[i].y);
    cv::line(picture, from, to, rim_colour, width + 2, cv::LINE_AA, fraction_bits);
    cv::line(picture, from, to, colours[i - 1], width, cv::LINE_AA, fraction_bits);
  }
}

}  // namespace runmark::cli
