#pragma once

#include <cmath>
#include <optional>

#include "runmark/marker.h"

namespace runmark {

/// The line of all p with normal . p = offset; the normal has length 1.
struct Line {
  Point normal{};
  double offset = 0;
  [[nodiscard]] double distance(Point p) const { return normal.x * p.x + normal.y * p.y - offset; }
};

/// Where two lines meet, or nothing when they are within half a degree of parallel.
[[nodiscard]] inline std::optional<Point> meet(const Line& a, const Line& b) {
  constexpr double least_sine = 0.0087;
  const double sine = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
  if (std::fabs(sine) < least_sine) return std::nullopt;
  return Point{(a.offset * b.normal.y - b.offset * a.normal.y) / sine,
               (a.normal.x * b.offset - b.normal.x * a.offset) / sine};
}

/// Sums over unit cracks, relative to a line fit's origin: how many, and of x, y, xx, xy and yy.
struct CrackMoments {
  double n = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  double yy = 0;
};

/// Moments of cracks: the total least squares line through them without keeping them.
/// Coordinates are taken relative to an origin near the points, so that nothing cancels.
class LineFit {
 public:
  explicit LineFit(Point origin) : origin_(origin) {}

  /// The unit cracks of an axis-parallel run from `a` to `b`, by their midpoints.
  void add_cracks(Point a, Point b) {
    const double length = std::fabs(b.x - a.x) + std::fabs(b.y - a.y);
    const double x = (a.x + b.x) / 2 - origin_.x;
    const double y = (a.y + b.y) / 2 - origin_.y;
    const double spread =
        (length * length * length - length) / 12;  // of `length` unit steps about their mean
    add_moments({length, length * x, length * y, length * x * x + (a.y == b.y ? spread : 0), length * x * y,
                 length * y * y + (a.x == b.x ? spread : 0)});
  }

  void add_moments(const CrackMoments& m) {
    sum_.n += m.n;
    sum_.x += m.x;
    sum_.y += m.y;
    sum_.xx += m.xx;
    sum_.xy += m.xy;
    sum_.yy += m.yy;
  }

  /// The line with the least squared distances; nothing with fewer than two points' weight.
  [[nodiscard]] std::optional<Line> line() const {
    if (sum_.n <= 0) return std::nullopt;
    const Spread s = spread();
    if (s.root <= 0) return std::nullopt;
    // Direction of the larger eigenvalue, by the better conditioned of two formulas.
    const Point along = s.half >= 0 ? Point{s.half + s.root, s.xy} : Point{s.xy, s.root - s.half};
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length <= 0) return std::nullopt;
    const Point normal{-along.y / length, along.x / length};
    return Line{normal, normal.x * (sum_.x / sum_.n + origin_.x) + normal.y * (sum_.y / sum_.n + origin_.y)};
  }

  /// Mean squared distance from the fitted line.
  [[nodiscard]] double mean_square() const {
    if (sum_.n <= 0) return 0;
    const Spread s = spread();
    const double smaller = s.mean - s.root;
    return smaller > 0 ? smaller : 0;
  }

 private:
  /// The points' covariance: its eigenvalues are mean + root and mean - root.
  struct Spread {
    double mean = 0;  // of the variances along x and y
    double half = 0;  // half their difference
    double xy = 0;
    double root = 0;
  };

  [[nodiscard]] Spread spread() const {
    const double mx = sum_.x / sum_.n;
    const double my = sum_.y / sum_.n;
    const double xx = sum_.xx / sum_.n - mx * mx;
    const double xy = sum_.xy / sum_.n - mx * my;
    const double yy = sum_.yy / sum_.n - my * my;
    const double half = (xx - yy) / 2;
    return {(xx + yy) / 2, half, xy, std::sqrt(half * half + xy * xy)};
  }

  Point origin_;
  CrackMoments sum_;
};

}  // namespace runmark
