#include "corner/quad_from_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "corner/line_fit.h"

namespace runmark {
namespace {

using Vertices = std::span<const Vertex>;
using Indices = std::array<std::size_t, 4>;

struct Outline {
  Vertices vertices;  // clockwise
  int area = 0;       // of the pixels inside
  int width = 0;
  int height = 0;
  int perimeter = 0;  // in cracks
};

Outline outline_of(const ClosedChain& chain, std::span<Vertex> scratch) {
  Vertex* next = scratch.data();
  int area = 0;
  int perimeter = 0;
  int left = chain.pool->operator[](chain.tail).x;
  int right = left;
  int line = chain.bottom;
  chain.runs([&](int from, int to, int y) {
    *next++ = {static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(y)};
    *next++ = {static_cast<std::uint16_t>(to), static_cast<std::uint16_t>(y)};
    area += y * (from - to);
    perimeter += std::abs(to - from) + std::abs(y - line);
    line = y;
    left = std::min(left, to);
    right = std::max(right, to);
  });
  const std::span<Vertex> vertices(scratch.data(), next);
  if (chain.hole) std::reverse(vertices.begin(), vertices.end());
  return {vertices, std::abs(area), right - left, chain.bottom - chain.top, perimeter};
}

/// Whether the outline may be a quadrilateral's: a convex one fills a good part of the box round it and is
/// as long as the box's, and a ragged edge makes it a little longer.
bool may_be_quad(const Outline& o) {
  const int box = o.width * o.height;
  return 5 * o.area >= box && o.perimeter <= 3 * (o.width + o.height) + 8;
}

std::size_t farthest_from(Vertices vertices, int x, int y) {
  std::size_t best = 0;
  std::int64_t most = -1;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::int64_t dx = vertices[i].x - x;
    const std::int64_t dy = vertices[i].y - y;
    const std::int64_t distance = dx * dx + dy * dy;
    if (distance > most) {
      most = distance;
      best = i;
    }
  }
  return best;
}

struct BothSides {
  std::size_t right = 0;
  std::size_t left = 0;
};

/// The vertices farthest from the line a -> b on its right hand and on its left hand in the image.
BothSides farthest_from_line(Vertices vertices, std::size_t a, std::size_t b) {
  const std::int64_t ux = vertices[b].x - vertices[a].x;
  const std::int64_t uy = vertices[b].y - vertices[a].y;
  BothSides best{a, a};
  std::int64_t most_right = 0;
  std::int64_t most_left = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::int64_t across = ux * (vertices[i].y - vertices[a].y) - uy * (vertices[i].x - vertices[a].x);
    if (across > most_right) {
      most_right = across;
      best.right = i;
    } else if (across < most_left) {
      most_left = across;
      best.left = i;
    }
  }
  return best;
}

/// Four vertices that span a large area, in the order of the outline. Starts from the two ends of a long
/// diagonal and lets each pair of opposite corners choose the other until nothing moves.
std::optional<Indices> widest_corners(Vertices vertices) {
  const std::size_t a = farthest_from(vertices, vertices[0].x, vertices[0].y);
  const std::size_t c = farthest_from(vertices, vertices[a].x, vertices[a].y);
  Indices corners{a, 0, c, 0};
  constexpr int most_rounds = 3;
  for (int round = 0; round < most_rounds; ++round) {
    const BothSides one = farthest_from_line(vertices, corners[0], corners[2]);
    const bool same = corners[1] == one.left && corners[3] == one.right;
    corners[1] = one.left;
    corners[3] = one.right;
    if (corners[1] == corners[3] || same) break;
    const BothSides two = farthest_from_line(vertices, corners[1], corners[3]);
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

Point crack_point(Vertex v) { return {v.x - 0.5, v.y - 0.5}; }

/// The line through the cracks of the outline from one corner to the next. Cracks near the corners are left
/// out, because blur rounds them, and those far from the straight way: white cells beside a blurred border
/// break through it, and the outline goes in there and comes out again.
std::optional<Line> side_line(Vertices vertices, std::size_t from, std::size_t to, double tolerance) {
  const Point a = crack_point(vertices[from]);
  const Point b = crack_point(vertices[to]);
  const Point u{b.x - a.x, b.y - a.y};
  const double length = std::sqrt(u.x * u.x + u.y * u.y);
  if (length <= 0) return std::nullopt;
  const double margin = std::min(0.15 * length, 1.0 + 0.05 * length);
  const double low = margin * length;
  const double high = (length - margin) * length;
  const double band = 2.5 * tolerance * length;
  constexpr double least_covered = 0.4;  // of the way
  double covered = 0;
  LineFit fit({(a.x + b.x) / 2, (a.y + b.y) / 2});
  const std::size_t count = vertices.size();
  for (std::size_t i = from; i != to;) {
    const std::size_t next = i + 1 == count ? 0 : i + 1;
    Point p = crack_point(vertices[i]);
    Point q = crack_point(vertices[next]);
    i = next;
    // Clip the run to the inner part of the side, by its share along the side.
    const double sp = (p.x - a.x) * u.x + (p.y - a.y) * u.y;
    const double sq = (q.x - a.x) * u.x + (q.y - a.y) * u.y;
    const double rise = sq - sp;
    if (rise == 0) {
      if (sp < low || sp > high) continue;
    } else {
      const double t0 = std::clamp(((rise > 0 ? low : high) - sp) / rise, 0.0, 1.0);
      const double t1 = std::clamp(((rise > 0 ? high : low) - sp) / rise, 0.0, 1.0);
      if (t1 <= t0) continue;
      const Point d{q.x - p.x, q.y - p.y};
      q = {p.x + t1 * d.x, p.y + t1 * d.y};
      p = {p.x + t0 * d.x, p.y + t0 * d.y};
    }
    const auto off = [&](Point v) { return (v.x - a.x) * u.y - (v.y - a.y) * u.x; };
    const double forward = (q.x - p.x) * u.x + (q.y - p.y) * u.y;
    if (std::fabs(off(p) + off(q)) > 2 * band || std::fabs(off(q) - off(p)) > std::max(band, forward))
      continue;
    covered += forward;
    fit.add_cracks(p, q);
  }
  if (covered < least_covered * (high - low)) return std::nullopt;
  if (fit.mean_square() > tolerance * tolerance) return std::nullopt;
  std::optional<Line> line = fit.line();
  if (!line) return std::nullopt;
  // A side whose line does not run from corner to corner was bent elsewhere.
  const double along = std::fabs(line->normal.x * u.x + line->normal.y * u.y);
  if (along > 0.35 * length) return std::nullopt;
  return line;
}

}  // namespace

std::optional<Quad> quad_from_chain(const ClosedChain& chain, const QuadLimits& limits,
                                    std::span<Vertex> scratch) {
  const Outline outline = outline_of(chain, scratch);
  if (outline.area < limits.min_area || outline.area > limits.max_area) return std::nullopt;
  if (!may_be_quad(outline)) return std::nullopt;
  const std::optional<Indices> corners = widest_corners(outline.vertices);
  if (!corners) return std::nullopt;

  std::array<Point, 4> rough{};
  double perimeter = 0;
  for (std::size_t i = 0; i < 4; ++i) rough[i] = crack_point(outline.vertices[(*corners)[i]]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = rough[i];
    const Point b = rough[(i + 1) % 4];
    const double side = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    if (side < limits.min_side) return std::nullopt;
    perimeter += side;
  }
  const double spanned = area_of(rough);
  const double missing = spanned - outline.area;
  if (missing < -0.1 * spanned - 0.5 * perimeter || missing > 0.1 * spanned + 1.5 * perimeter) {
    return std::nullopt;
  }

  const double tolerance = 0.6 + 0.004 * perimeter;
  std::array<Line, 4> lines{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto line = side_line(outline.vertices, (*corners)[i], (*corners)[(i + 1) % 4], tolerance);
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
