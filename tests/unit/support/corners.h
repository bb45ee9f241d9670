#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "corner/quad.h"
#include "runmark/marker.h"

namespace runmark::test {

using Corners = std::array<Point, 4>;

/// Whether a point lies in a convex quadrilateral whose corners go clockwise.
inline bool inside(const Corners& corners, double x, double y) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (cross(corners[i], corners[(i + 1) % 4], {x, y}) < 0) return false;
  }
  return true;
}

/// How far the worst corner is from the same corner of the truth.
inline double worst_corner(const Marker& marker, const Corners& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    worst = std::max(worst, std::hypot(marker.corners[i].x - truth[i].x, marker.corners[i].y - truth[i].y));
  }
  return worst;
}

/// How far the worst corner of the truth is from the nearest one found.
inline double worst_corner(const Corners& truth, const Corners& found) {
  double worst = 0;
  for (const Point& t : truth) {
    double nearest = std::numeric_limits<double>::max();
    for (const Point& f : found) nearest = std::min(nearest, std::hypot(f.x - t.x, f.y - t.y));
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace runmark::test
