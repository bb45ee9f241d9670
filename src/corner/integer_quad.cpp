#include "corner/integer_quad.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "corner/chain_extremes.h"
#include "corner/side_fit.h"

namespace runmark {
namespace {

using Corners = std::array<NumberedVertex, 4>;

/// Roughly the length of all sides; 0 when one is too short.
std::int32_t perimeter_of(const Corners& c, int min_side) {
  std::int32_t perimeter = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int32_t dx = std::abs(c[(i + 1) % 4].x - c[i].x);
    const std::int32_t dy = std::abs(c[(i + 1) % 4].y - c[i].y);
    const std::int32_t longer = std::max(dx, dy);
    if (longer < min_side) return 0;
    perimeter += longer + std::min(dx, dy) / 2;
  }
  return perimeter;
}

/// Whether the rough corners' quadrilateral has about the chain's area.
bool is_filled(const Corners& c, std::int64_t area, std::int32_t perimeter) {
  const std::int64_t twice = std::abs(static_cast<std::int64_t>(c[2].x - c[0].x) * (c[3].y - c[1].y) -
                                      static_cast<std::int64_t>(c[3].x - c[1].x) * (c[2].y - c[0].y));
  return std::abs(twice - 2 * area) <= (twice >> 3) + perimeter;
}

/// In sixteenths of a pixel, down plus across.
std::int32_t distance(SubpixelPoint p, const NumberedVertex& rough) {
  constexpr std::int32_t half = 1 << (subpixel_bits - 1);
  return std::abs(p.x + half - (rough.x << subpixel_bits)) +
         std::abs(p.y + half - (rough.y << subpixel_bits));
}

/// The second walk: every crack goes to the side it lies on.
std::array<SideFit, 4> fit_sides(const ClosedChain& chain, const Corners& corners) {
  std::array<SideFit, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) sides[i] = SideFit(corners[i], corners[(i + 1) % 4]);
  std::size_t side = 3;  // the chain begins between the last corner and the first
  std::int32_t number = 0;
  const auto pass = [&] {
    const std::size_t next = (side + 1) % 4;
    if (number++ == corners[next].number) side = next;
  };
  std::int32_t above = (*chain.pool)[chain.tail].y;
  chain.runs([&](std::int32_t from, std::int32_t to, std::int32_t y) {
    sides[side].add_vertical(from, above, y);
    pass();
    sides[side].add_horizontal(from, to, y);
    pass();
    above = y;
  });
  return sides;
}

}  // namespace

std::optional<IntegerQuad> integer_quad(const ClosedChain& chain, const IntegerQuadLimits& limits) {
  const ChainExtremes extremes = chain_extremes(chain);
  if (extremes.area < limits.min_area || extremes.area > limits.max_area) return std::nullopt;
  const auto corners = widest_corners(extremes);
  if (!corners) return std::nullopt;
  const std::int32_t perimeter = perimeter_of(*corners, limits.min_side);
  if (perimeter == 0 || !is_filled(*corners, extremes.area, perimeter)) return std::nullopt;

  const std::array<SideFit, 4> sides = fit_sides(chain, *corners);
  std::array<IntegerLine, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto line = sides[i].line();
    if (!line) return std::nullopt;
    lines[i] = *line;
  }
  IntegerQuad quad;
  quad.light_inside = chain.hole;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto corner = meet(lines[(i + 3) % 4], lines[i]);
    if (!corner || distance(*corner, (*corners)[i]) > (2 << subpixel_bits) + perimeter) return std::nullopt;
    // A hole is followed the other way round.
    quad.corners[chain.hole ? 3 - i : i] = *corner;
  }
  return quad;
}

}  // namespace runmark
