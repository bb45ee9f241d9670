#include "render/geometry.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace runmark::render {

double area(const Quad& quad) {
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = quad[i];
    const Point b = quad[(i + 1) % 4];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

namespace {

// Whether a line along one of the sides of `a` has `a` on one side and `b` on the other.
bool side_separates(const Quad& a, const Quad& b) {
  const auto span = [](const Quad& quad, double nx, double ny) {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const Point p : quad) {
      const double t = nx * p.x + ny * p.y;
      low = std::min(low, t);
      high = std::max(high, t);
    }
    return std::array{low, high};
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const double nx = a[(i + 1) % 4].y - a[i].y;
    const double ny = a[i].x - a[(i + 1) % 4].x;
    const auto [a_low, a_high] = span(a, nx, ny);
    const auto [b_low, b_high] = span(b, nx, ny);
    if (a_high < b_low || b_high < a_low) return true;
  }
  return false;
}

}  // namespace

bool overlap(const Quad& a, const Quad& b) { return !side_separates(a, b) && !side_separates(b, a); }

Homography Homography::inverse() const {
  const auto minor = [this](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return m[a] * m[d] - m[b] * m[c];
  };
  Homography h{{minor(4, 5, 7, 8), minor(2, 1, 8, 7), minor(1, 2, 4, 5),  //
                minor(5, 3, 8, 6), minor(0, 2, 6, 8), minor(2, 0, 5, 3),  //
                minor(3, 4, 6, 7), minor(1, 0, 7, 6), minor(0, 1, 3, 4)}};
  const double determinant = m[0] * h.m[0] + m[1] * h.m[3] + m[2] * h.m[6];
  for (double& value : h.m) value /= determinant;
  return h;
}

}  // namespace runmark::render
