#include "corner/quad_from_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "corner/side_cracks.h"

namespace runmark {
namespace {

using Indices = std::array<std::size_t, 4>;

/// What one walk along a chain tells.
struct Shape {
  std::int64_t area = 0;  // of the pixels inside
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::int64_t perimeter = 0;  // in cracks
};

/// Draws the chain clockwise, whichever way it goes; the first vertex stands once more behind the last. The
/// next record is only known when this one is there, so drawing costs no more than looking.
Shape draw(const ClosedChain& chain, Outline& outline) {
  std::int64_t area = 0;
  int perimeter = 0;
  int left = (*chain.pool)[chain.tail].x;
  int right = left;
  int line = chain.bottom;
  outline.count = 2 * static_cast<std::size_t>(chain.records);
  std::size_t i = chain.hole ? outline.count - 1 : 0;
  const std::size_t step = chain.hole ? static_cast<std::size_t>(-1) : 1;
  chain.runs([&](int from, int to, int y) {
    outline.x[i] = static_cast<float>(from);
    outline.y[i] = static_cast<float>(y);
    i += step;
    outline.x[i] = static_cast<float>(to);
    outline.y[i] = static_cast<float>(y);
    i += step;
    area += static_cast<std::int64_t>(y) * (from - to);
    perimeter += std::abs(to - from) + std::abs(y - line);
    line = y;
    left = std::min(left, to);
    right = std::max(right, to);
  });
  outline.x[outline.count] = outline.x[0];
  outline.y[outline.count] = outline.y[0];
  return {std::abs(area), right - left, chain.bottom - chain.top, perimeter};
}

/// Whether the shape may be a quadrilateral: a convex one fills a good part of the box round it and is as
/// long as the box is, and a ragged edge makes it a little longer.
bool may_be_quad(const Shape& s) {
  return 5 * s.area >= s.width * s.height && s.perimeter <= 6 * (s.width + s.height) + 8;
}

/// Four vertices that span a large area, in the order of the outline. Starts from the two ends of a long
/// diagonal and lets each pair of opposite corners choose the other until nothing moves.
std::optional<Indices> widest_corners(const Outline& outline) {
  const std::size_t a = farthest_from(outline, 0);
  const std::size_t c = farthest_from(outline, a);
  Indices corners{a, 0, c, 0};
  constexpr int most_rounds = 3;
  for (int round = 0; round < most_rounds; ++round) {
    const BothSides one = farthest_from_line(outline, corners[0], corners[2]);
    const bool same = corners[1] == one.left && corners[3] == one.right;
    corners[1] = one.left;
    corners[3] = one.right;
    if (corners[1] == corners[3] || same) break;
    const BothSides two = farthest_from_line(outline, corners[1], corners[3]);
    corners[2] = two.left;
    corners[0] = two.right;
  }
  // In the order of the outline, which is clockwise.
  std::sort(corners.begin(), corners.end());
  for (std::size_t i = 0; i + 1 < 4; ++i) {
    if (corners[i] == corners[i + 1]) return std::nullopt;
  }
  return corners;
}

/// The line through the cracks of the outline from one corner to the next. Cracks near the corners are left
/// out, because blur rounds them, and those far from the straight way: white cells beside a blurred border
/// break through it, and the outline goes in there and comes out again.
std::optional<Line> side_line(const Outline& outline, std::size_t from, std::size_t to, double tolerance) {
  const Point a = crack_point(outline, from);
  const Point b = crack_point(outline, to);
  const Point u{b.x - a.x, b.y - a.y};
  const double length = std::sqrt(u.x * u.x + u.y * u.y);
  if (length <= 0) return std::nullopt;
  const double margin = std::min(0.15 * length, 1.0 + 0.05 * length);
  const SideWay way{a, u, margin * length, (length - margin) * length, 2.5 * tolerance * length};
  constexpr double least_covered = 0.4;  // of the way
  const SideCracks cracks = side_cracks(outline, from, to, way);
  if (cracks.covered < least_covered * (way.high - way.low)) return std::nullopt;
  if (cracks.fit.mean_square() > tolerance * tolerance) return std::nullopt;
  std::optional<Line> line = cracks.fit.line();
  if (!line) return std::nullopt;
  // A side whose line does not run from corner to corner was bent elsewhere.
  const double along = std::fabs(line->normal.x * u.x + line->normal.y * u.y);
  if (along > 0.35 * length) return std::nullopt;
  return line;
}

}  // namespace

std::optional<Quad> quad_from_chain(const ClosedChain& chain, const QuadLimits& limits, Outline& outline) {
  const Shape shape = draw(chain, outline);
  const auto area = static_cast<double>(shape.area);
  if (area < limits.min_area || area > limits.max_area || !may_be_quad(shape)) return std::nullopt;
  const std::optional<Indices> corners = widest_corners(outline);
  if (!corners) return std::nullopt;

  std::array<Point, 4> rough{};
  double perimeter = 0;
  for (std::size_t i = 0; i < 4; ++i) rough[i] = crack_point(outline, (*corners)[i]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = rough[i];
    const Point b = rough[(i + 1) % 4];
    const double side = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    if (side < limits.min_side) return std::nullopt;
    perimeter += side;
  }
  const double spanned = area_of(rough);
  const double missing = spanned - area;
  if (missing < -0.1 * spanned - 0.5 * perimeter || missing > 0.1 * spanned + 1.5 * perimeter) {
    return std::nullopt;
  }

  const double tolerance = 0.6 + 0.004 * perimeter;
  std::array<Line, 4> lines{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto line = side_line(outline, (*corners)[i], (*corners)[(i + 1) % 4], tolerance);
    if (!line) return std::nullopt;
    lines[i] = *line;
  }
  Quad quad;
  quad.light_inside = chain.hole;
  const double furthest = 2 + 0.05 * perimeter;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> corner = meet(lines[(i + 3) % 4], lines[i]);
    if (!corner || std::fabs(corner->x - rough[i].x) + std::fabs(corner->y - rough[i].y) > furthest) {
      return std::nullopt;
    }
    quad.corners[i] = *corner;
  }
  if (!is_convex_clockwise(quad.corners)) return std::nullopt;
  return quad;
}

}  // namespace runmark
