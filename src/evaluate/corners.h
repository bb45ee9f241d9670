#pragma once

#include <array>
#include <cmath>

#include "runmark/marker.h"

namespace runmark {

/// Top-left, top-right, bottom-right, bottom-left of a marker as it is drawn, in pixels.
using Corners = std::array<Point, 4>;

[[nodiscard]] inline double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The mean of the four corners.
[[nodiscard]] inline Point centre(const Corners& c) {
  return {(c[0].x + c[1].x + c[2].x + c[3].x) / 4, (c[0].y + c[1].y + c[2].y + c[3].y) / 4};
}

/// The mean length of the four sides.
[[nodiscard]] inline double mean_side(const Corners& c) {
  return (distance(c[0], c[1]) + distance(c[1], c[2]) + distance(c[2], c[3]) + distance(c[3], c[0])) / 4;
}

/// The square root of the quadrilateral's area: what this project calls the size of a marker.
[[nodiscard]] inline double marker_size(const Corners& c) {
  const double twice = (c[2].x - c[0].x) * (c[3].y - c[1].y) - (c[3].x - c[1].x) * (c[2].y - c[0].y);
  return std::sqrt(std::abs(twice) / 2);
}

}  // namespace runmark
