#pragma once

#include <array>

#include "runmark/marker.h"

namespace runmark {

/// The projective map of the plane that takes the square (0, 0), (side, 0), (side, side), (0, side) to
/// four corners in that order (Heckbert, "Fundamentals of texture mapping and image warping", 1989,
/// section 2.2.3). The corners must be convex.
class Homography {
 public:
  Homography(const std::array<Point, 4>& corners, double side) : origin_(corners[0]) {
    const auto& [p0, p1, p2, p3] = corners;
    const double dx1 = p1.x - p2.x;
    const double dx2 = p3.x - p2.x;
    const double dx3 = p0.x - p1.x + p2.x - p3.x;
    const double dy1 = p1.y - p2.y;
    const double dy2 = p3.y - p2.y;
    const double dy3 = p0.y - p1.y + p2.y - p3.y;
    const double det = dx1 * dy2 - dx2 * dy1;
    g_ = (dx3 * dy2 - dx2 * dy3) / det;
    h_ = (dx1 * dy3 - dx3 * dy1) / det;
    xu_ = (p1.x - p0.x + g_ * p1.x) / side;
    xv_ = (p3.x - p0.x + h_ * p3.x) / side;
    yu_ = (p1.y - p0.y + g_ * p1.y) / side;
    yv_ = (p3.y - p0.y + h_ * p3.y) / side;
    g_ /= side;
    h_ /= side;
  }

  [[nodiscard]] Point operator()(double u, double v) const {
    const double w = g_ * u + h_ * v + 1;
    return {(xu_ * u + xv_ * v + origin_.x) / w, (yu_ * u + yv_ * v + origin_.y) / w};
  }

 private:
  Point origin_;
  double g_ = 0;
  double h_ = 0;
  double xu_ = 0;
  double xv_ = 0;
  double yu_ = 0;
  double yv_ = 0;
};

}  // namespace runmark
