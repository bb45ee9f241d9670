#include "pattern/edge_refine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <cstdint>
#include <optional>

#include "corner/line_fit.h"

namespace runmark {
namespace {

constexpr int most_samples = 24;  // on each side

/// A side's edge relative to the straight line from corner to corner: its offset outwards at t from 0 to 1
/// is a + b (t - 1/2) + c (t - 1/2)^2. A lens bows long sides.
struct Bow {
  double a = 0;
  double b = 0;
  double c = 0;
  [[nodiscard]] double at(double t) const { return a + (b + c * (t - 0.5)) * (t - 0.5); }
  [[nodiscard]] double slope(double t) const { return b + 2 * c * (t - 0.5); }
};

struct EdgeSample {
  double t = 0;
  double offset = 0;  // pixels outwards
  double weight = 0;  // squared contrast
};

/// The first search weighs by the square, which singles out the strongest edge within reach; the second,
/// closely round it, weighs the rise itself: its first moment is where an evenly lit pixel grid was cut.
enum class Weigh : std::uint8_t { square, rise };

/// How far the edge is from `centre`, along the normal; no weight where the grey level does not rise.
EdgeSample edge_near(const GreyFrame& frame, Point at, Point normal, double centre, double reach, double step,
                     double sign, Weigh weigh) {
  const auto grey = [&](double n) {
    return static_cast<double>(
        frame.sample(static_cast<float>(at.x + n * normal.x), static_cast<float>(at.y + n * normal.y)));
  };
  const int steps = static_cast<int>(std::ceil(reach / step));
  double weight = 0;
  double sum = 0;
  double before = grey(centre - (steps + 0.5) * step);
  for (int i = -steps; i <= steps; ++i) {
    const double n = centre + i * step;
    const double after = grey(n + step / 2);
    const double rise = sign * (after - before);
    before = after;
    if (rise <= 0) continue;
    const double share = weigh == Weigh::square ? rise * rise : rise;
    weight += share;
    sum += share * n;
  }
  if (weight <= 0) return {};
  return {0, sum / weight, weigh == Weigh::square ? weight : weight * weight};
}

/// Weighted least squares of a Bow through samples, in moments.
class BowFit {
 public:
  void add(const EdgeSample& sample) {
    const double x = sample.t - 0.5;
    double power = sample.weight;
    for (std::size_t k = 0; k < 5; ++k, power *= x) {
      x_[k] += power;
      if (k < 3) y_[k] += power * sample.offset;
    }
    yy_ += sample.weight * sample.offset * sample.offset;
  }

  [[nodiscard]] Bow straight() const {
    const double det = x_[0] * x_[2] - x_[1] * x_[1];
    if (det <= 0) return {y_[0] / x_[0], 0, 0};
    return {(y_[0] * x_[2] - y_[1] * x_[1]) / det, (x_[0] * y_[1] - x_[1] * y_[0]) / det, 0};
  }

  /// The parabola where it explains the samples far better than the line does, else the line.
  [[nodiscard]] Bow bow(int samples) const {
    constexpr int least_samples = 12;
    constexpr double clearly_better = 10;
    const Bow line = straight();
    if (samples < least_samples) return line;
    const double m00 = x_[2] * x_[4] - x_[3] * x_[3];
    const double m01 = x_[2] * x_[3] - x_[1] * x_[4];
    const double m02 = x_[1] * x_[3] - x_[2] * x_[2];
    const double m11 = x_[0] * x_[4] - x_[2] * x_[2];
    const double m12 = x_[1] * x_[2] - x_[0] * x_[3];
    const double m22 = x_[0] * x_[2] - x_[1] * x_[1];
    const double det = x_[0] * m00 + x_[1] * m01 + x_[2] * m02;
    if (det <= 0) return line;
    const Bow curve{(m00 * y_[0] + m01 * y_[1] + m02 * y_[2]) / det,
                    (m01 * y_[0] + m11 * y_[1] + m12 * y_[2]) / det,
                    (m02 * y_[0] + m12 * y_[1] + m22 * y_[2]) / det};
    const double left = residual(curve);
    return (residual(line) - left) * (samples - 3) > clearly_better * left ? curve : line;
  }

 private:
  [[nodiscard]] double residual(const Bow& f) const {
    return std::max(yy_ - f.a * y_[0] - f.b * y_[1] - f.c * y_[2], 1e-9 * x_[0]);
  }

  std::array<double, 5> x_{};  // sums of weight * x^k
  std::array<double, 3> y_{};  // sums of weight * offset * x^k
  double yy_ = 0;
};

/// The edge's tangents at the side's two ends: corners are where those of neighbouring sides meet.
struct SideEdge {
  Line at_start;
  Line at_end;
};

std::optional<SideEdge> refine_side(const GreyFrame& frame, Point a, Point b, double reach, double sign) {
  constexpr double margin = 0.08;  // of the side at each end, where blur rounds the corner
  constexpr double least_weight = 16;
  constexpr double close_reach = 1.5;
  constexpr double long_side = 48;  // pixels; shorter ones bow too little to tell
  const Point u{b.x - a.x, b.y - a.y};
  const double length = std::sqrt(u.x * u.x + u.y * u.y);
  const Point normal{u.y / length, -u.x / length};  // outwards: the corners go clockwise
  Bow bow;
  const auto search = [&](int samples, double within, double step, Weigh weigh) {
    BowFit fit;
    int clear = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = margin + (1 - 2 * margin) * (i + 0.5) / samples;
      const Point at{a.x + t * u.x, a.y + t * u.y};
      EdgeSample edge = edge_near(frame, at, normal, bow.at(t), within, step, sign, weigh);
      if (edge.weight <= least_weight) continue;
      edge.t = t;
      fit.add(edge);
      ++clear;
    }
    if (clear < 2 || clear < samples / 2) return false;
    bow = weigh == Weigh::rise && length > long_side ? fit.bow(clear) : fit.straight();
    return std::max(std::fabs(bow.at(0)), std::fabs(bow.at(1))) <= reach + 1;
  };
  const int samples = std::clamp(static_cast<int>(length / 1.5), 4, most_samples);
  if (!search(std::min(samples, 10), reach, 0.5, Weigh::square)) return std::nullopt;
  if (!search(samples, std::min(reach, close_reach), 0.5, Weigh::rise)) return std::nullopt;

  const auto tangent = [&](double t) {
    const double slope = bow.slope(t);
    Point across{length * normal.x - slope * u.x / length, length * normal.y - slope * u.y / length};
    const double size = std::sqrt(across.x * across.x + across.y * across.y);
    across = {across.x / size, across.y / size};
    const double offset = bow.at(t);
    const Point on{a.x + t * u.x + offset * normal.x, a.y + t * u.y + offset * normal.y};
    return Line{across, across.x * on.x + across.y * on.y};
  };
  return SideEdge{tangent(0), tangent(1)};
}

}  // namespace

Quad refine_edges(const GreyFrame& frame, const Quad& quad, int cells, double reach) {
  const double side = std::sqrt(std::max(area_of(quad.corners), 1.0));
  const double within_cell = std::max(0.8, 0.8 * side / cells);
  const double search = std::min(reach, within_cell);
  const double sign = quad.light_inside ? -1 : 1;
  std::array<SideEdge, 4> sides{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto edge = refine_side(frame, quad.corners[i], quad.corners[(i + 1) % 4], search, sign);
    if (!edge) return quad;
    sides[i] = *edge;
  }
  Quad refined = quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> corner = meet(sides[(i + 3) % 4].at_end, sides[i].at_start);
    if (!corner) return quad;
    const double moved = std::fabs(corner->x - quad.corners[i].x) + std::fabs(corner->y - quad.corners[i].y);
    if (moved > 2 * search + 1) return quad;
    refined.corners[i] = *corner;
  }
  return is_convex_clockwise(refined.corners) ? refined : quad;
}

}  // namespace runmark
