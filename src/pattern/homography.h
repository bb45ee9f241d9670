#pragma once

#include <array>

#include "runmark/marker.h"

namespace runmark {

/// The projective map of the plane that takes the square (0, 0), (side, 0), (side, side), (0, side) to
/// four corners in that order (Heckbert, "Fundamentals of texture mapping and image warping", 1989,
/// section 2.2.3). The corners must be convex.
class Homography {
 public:
  /// x = (xu u + xv v + x0) / (g u + h v + 1), and y alike.
  struct Coefficients {
    double xu = 0;
    double xv = 0;
    double x0 = 0;
    double yu = 0;
    double yv = 0;
    double y0 = 0;
    double g = 0;
    double h = 0;
  };

  Homography(const std::array<Point, 4>& corners, double side) {
    const auto& [p0, p1, p2, p3] = corners;
    const double dx1 = p1.x - p2.x;
    const double dx2 = p3.x - p2.x;
    const double dx3 = p0.x - p1.x + p2.x - p3.x;
    const double dy1 = p1.y - p2.y;
    const double dy2 = p3.y - p2.y;
    const double dy3 = p0.y - p1.y + p2.y - p3.y;
    const double det = dx1 * dy2 - dx2 * dy1;
    const double g = (dx3 * dy2 - dx2 * dy3) / det;
    const double h = (dx1 * dy3 - dx3 * dy1) / det;
    c_ = {(p1.x - p0.x + g * p1.x) / side,
          (p3.x - p0.x + h * p3.x) / side,
          p0.x,
          (p1.y - p0.y + g * p1.y) / side,
          (p3.y - p0.y + h * p3.y) / side,
          p0.y,
          g / side,
          h / side};
  }

  [[nodiscard]] Point operator()(double u, double v) const {
    const double w = c_.g * u + c_.h * v + 1;
    return {(c_.xu * u + c_.xv * v + c_.x0) / w, (c_.yu * u + c_.yv * v + c_.y0) / w};
  }

  [[nodiscard]] const Coefficients& coefficients() const { return c_; }

 private:
  Coefficients c_{};
};

}  // namespace runmark
