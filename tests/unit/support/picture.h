#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "pattern/grey_frame.h"
#include "pattern/homography.h"
#include "render/draw_marker.h"
#include "runmark/dictionary.h"
#include "runmark/image_view.h"
#include "runmark/marker.h"

namespace runmark::test {

/// A grey frame that owns its pixels.
class Picture {
 public:
  Picture(int width, int height, std::uint8_t grey)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), grey) {
    for (int y = 0; y < height; ++y) rows_.push_back(&at(0, y));
  }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  [[nodiscard]] std::uint8_t& at(int x, int y) {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }
  [[nodiscard]] ImageView view() const { return ImageView::grey(pixels_.data(), width_, height_, width_); }
  [[nodiscard]] GreyFrame frame() const { return {rows_.data(), width_, height_, 1, PixelFormat::grey}; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Draws grey(u, v) where the plane map `to_plane` of a pixel's 4x4 sub-pixels falls; negative: leaves it.
  template <class Grey>
  void draw(Grey&& grey) {
    constexpr int parts = 4;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        double sum = 0;
        for (int j = 0; j < parts; ++j) {
          for (int i = 0; i < parts; ++i) {
            const double value = grey(x - 0.5 + (i + 0.5) / parts, y - 0.5 + (j + 0.5) / parts);
            sum += value < 0 ? at(x, y) : value;
          }
        }
        at(x, y) = static_cast<std::uint8_t>(sum / (parts * parts) + 0.5);
      }
    }
  }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;
  std::vector<const std::uint8_t*> rows_;
};

/// Corners of a square of that side about a centre, turned clockwise in the image by `degrees`.
inline std::array<Point, 4> turned_square(Point centre, double side, double degrees) {
  const double turn = degrees * std::acos(-1.0) / 180;
  const double c = std::cos(turn) * side / 2;
  const double s = std::sin(turn) * side / 2;
  return {{{centre.x - c + s, centre.y - s - c},
           {centre.x + c + s, centre.y + s - c},
           {centre.x + c - s, centre.y + s + c},
           {centre.x - c - s, centre.y - s + c}}};
}

/// Inverse of the map of the unit square to four corners.
class PlaneMap {
 public:
  explicit PlaneMap(const std::array<Point, 4>& corners) : forward_(corners, 1) {}
  /// Where the pixel point lies in the square (0 to 1 inside).
  [[nodiscard]] Point operator()(double x, double y) {
    // Newton's method from the last answer: points are asked for side by side.
    if (!(std::fabs(last_.x) + std::fabs(last_.y) < 10)) last_ = {0.5, 0.5};
    for (int i = 0; i < 20; ++i) {
      constexpr double h = 1e-5;
      const Point p = forward_(last_.x, last_.y);
      const double ex = x - p.x;
      const double ey = y - p.y;
      if (std::fabs(ex) + std::fabs(ey) < 1e-7) break;
      const Point pu = forward_(last_.x + h, last_.y);
      const Point pv = forward_(last_.x, last_.y + h);
      const double a = (pu.x - p.x) / h;
      const double b = (pv.x - p.x) / h;
      const double c = (pu.y - p.y) / h;
      const double d = (pv.y - p.y) / h;
      const double det = a * d - b * c;
      last_ = {last_.x + (d * ex - b * ey) / det, last_.y + (a * ey - c * ex) / det};
    }
    return last_;
  }

 private:
  Homography forward_;
  Point last_{0.5, 0.5};
};

/// Draws a marker with one white cell of margin so that its square has these corners.
inline void draw_at(Picture& picture, const Dictionary& dictionary, std::size_t id,
                    const std::array<Point, 4>& corners, bool inverted = false, double black = 30,
                    double white = 220) {
  const MarkerDrawing drawing = draw_marker(dictionary, id, 1, 1);
  PlaneMap map(corners);
  double left = corners[0].x;
  double right = left;
  double top = corners[0].y;
  double bottom = top;
  for (const Point& c : corners) {
    left = std::min(left, c.x);
    right = std::max(right, c.x);
    top = std::min(top, c.y);
    bottom = std::max(bottom, c.y);
  }
  const double reach = (right - left + bottom - top) / 2;
  picture.draw([&](double x, double y) {
    if (x < left - reach || x > right + reach || y < top - reach || y > bottom + reach) return -1.0;
    const Point uv = map(x, y);
    const double cu = uv.x * drawing.square + drawing.origin;
    const double cv = uv.y * drawing.square + drawing.origin;
    if (!(cu >= 0 && cv >= 0 && cu < drawing.side && cv < drawing.side)) return -1.0;
    const auto index =
        static_cast<std::size_t>(cv) * static_cast<std::size_t>(drawing.side) + static_cast<std::size_t>(cu);
    return (drawing.grey[index] > 127) != inverted ? white : black;
  });
}

}  // namespace runmark::test
