#include "pattern/edge_refine.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "corner/line_fit.h"

namespace runmark {
namespace {

/// How far the edge is from `at` along `normal`, and how clear it is (its squared contrast); no weight
/// when the grey level does not rise in that direction.
struct EdgeSample {
  double offset = 0;
  double weight = 0;
};

/// The first search weighs by the square, which singles out the strongest edge within reach; the second,
/// closely round it, weighs the rise itself: its first moment is where an evenly lit pixel grid was cut.
enum class Weigh : std::uint8_t { square, rise };

EdgeSample edge_near(const GreyFrame& frame, Point at, Point normal, double centre, double reach, double sign,
                     Weigh weigh) {
  constexpr double step = 0.5;
  const auto grey = [&](double n) {
    return static_cast<double>(
        frame.sample(static_cast<float>(at.x + n * normal.x), static_cast<float>(at.y + n * normal.y)));
  };
  double weight = 0;
  double sum = 0;
  double before = grey(centre - reach - step / 2);
  for (double n = centre - reach; n <= centre + reach + 1e-9; n += step) {
    const double after = grey(n + step / 2);
    const double rise = sign * (after - before);
    before = after;
    if (rise <= 0) continue;
    const double share = weigh == Weigh::square ? rise * rise : rise;
    weight += share;
    sum += share * n;
  }
  if (weight <= 0) return {};
  return {sum / weight, weigh == Weigh::square ? weight : weight * weight};
}

std::optional<Line> refine_side(const GreyFrame& frame, Point a, Point b, double reach, double sign) {
  const Point u{b.x - a.x, b.y - a.y};
  const double length = std::sqrt(u.x * u.x + u.y * u.y);
  const Point normal{u.y / length, -u.x / length};  // outwards: the corners go clockwise
  constexpr int most_samples = 24;
  const int samples = std::clamp(static_cast<int>(length / 1.5), 4, most_samples);
  const double margin = 0.08;

  double centre_a = 0;
  double centre_b = 0;
  std::optional<Line> line;
  for (int pass = 0; pass < 2; ++pass) {
    const double width = pass == 0 ? reach : std::min(reach, 1.5);
    LineFit fit({(a.x + b.x) / 2, (a.y + b.y) / 2});
    int clear = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = margin + (1 - 2 * margin) * (i + 0.5) / samples;
      const Point at{a.x + t * u.x, a.y + t * u.y};
      const double centre = centre_a + t * (centre_b - centre_a);
      const EdgeSample edge =
          edge_near(frame, at, normal, centre, width, sign, pass == 0 ? Weigh::square : Weigh::rise);
      if (edge.weight <= 16) continue;
      ++clear;
      fit.add({at.x + edge.offset * normal.x, at.y + edge.offset * normal.y}, edge.weight);
    }
    if (clear < samples / 2) return std::nullopt;
    line = fit.line();
    if (!line) return std::nullopt;
    // The next pass looks closely round this line.
    const double facing = line->normal.x * normal.x + line->normal.y * normal.y;
    if (std::fabs(facing) < 0.9) return std::nullopt;
    centre_a = -line->distance(a) / facing;
    centre_b = -line->distance(b) / facing;
    if (std::max(std::fabs(centre_a), std::fabs(centre_b)) > reach + 1) return std::nullopt;
  }
  return line;
}

}  // namespace

Quad refine_edges(const GreyFrame& frame, const Quad& quad, int cells, double reach) {
  const double side = std::sqrt(std::max(area_of(quad.corners), 1.0));
  const double within_cell = std::max(0.8, 0.8 * side / cells);
  const double search = std::min(reach, within_cell);
  const double sign = quad.light_inside ? -1 : 1;
  std::array<Line, 4> lines{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto line = refine_side(frame, quad.corners[i], quad.corners[(i + 1) % 4], search, sign);
    if (!line) return quad;
    lines[i] = *line;
  }
  Quad refined = quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> corner = meet(lines[(i + 3) % 4], lines[i]);
    if (!corner) return quad;
    const double moved = std::fabs(corner->x - quad.corners[i].x) + std::fabs(corner->y - quad.corners[i].y);
    if (moved > 2 * search + 1) return quad;
    refined.corners[i] = *corner;
  }
  return is_convex_clockwise(refined.corners) ? refined : quad;
}

}  // namespace runmark
