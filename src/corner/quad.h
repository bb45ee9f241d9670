#pragma once

#include <array>
#include <limits>

#include "runmark/marker.h"

namespace runmark {

/// A quadrilateral candidate: corners clockwise in the image, in pixels of its octave.
struct Quad {
  std::array<Point, 4> corners{};
  bool light_inside = false;  ///< the boundary of a light region (a hole); else of a dark one
  /// Standard deviation of the blur of its edges, in pixels; infinite until it was measured.
  double blur = std::numeric_limits<double>::infinity();
};

[[nodiscard]] inline double cross(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Area in square pixels; positive when the corners go clockwise in the image.
[[nodiscard]] inline double area_of(const std::array<Point, 4>& q) {
  return 0.5 * ((q[2].x - q[0].x) * (q[3].y - q[1].y) - (q[3].x - q[1].x) * (q[2].y - q[0].y));
}

[[nodiscard]] inline bool is_convex_clockwise(const std::array<Point, 4>& q) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (cross(q[i], q[(i + 1) % 4], q[(i + 2) % 4]) <= 0) return false;
  }
  return true;
}

}  // namespace runmark
