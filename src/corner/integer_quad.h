#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "contour/chain.h"
#include "runmark/marker.h"

namespace runmark {

/// Fractions of a pixel that the integer cores work in.
inline constexpr int subpixel_bits = 4;

/// A place in the image in sixteenths of a pixel; (0, 0) is the centre of the top-left pixel.
struct SubpixelPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend constexpr bool operator==(SubpixelPoint, SubpixelPoint) = default;
};

/// The same place in pixels: exact.
[[nodiscard]] constexpr Point in_pixels(SubpixelPoint p) { return {p.x / 16.0, p.y / 16.0}; }

/// A quadrilateral candidate of the integer cores: corners clockwise in the image.
struct IntegerQuad {
  std::array<SubpixelPoint, 4> corners{};
  bool light_inside = false;
  friend constexpr bool operator==(const IntegerQuad&, const IntegerQuad&) = default;
};

/// What a chain must be like to become a candidate; pixels and square pixels.
struct IntegerQuadLimits {
  std::int64_t min_area = 50;
  std::int64_t max_area = std::int64_t{1} << 40;
  int min_side = 3;
};

/// The corner core of `--pipeline hardware`: the quadrilateral a closed chain draws, at any rotation, in
/// integers and two walks along the chain's records.
///
/// The first walk keeps the area and the vertices that lie farthest in sixteen directions. Four of them that
/// span a wide quadrilateral are its rough corners. The second walk fits a line to the cracks of each side:
/// of a side that runs more across than down, to its horizontal cracks, one a column, so that sums of powers
/// of x are known without adding them up and a fold in the boundary cancels itself out. Neighbouring lines
/// meet in the corners.
///
/// Nothing when the area is not the quadrilateral's, when a side's line is not where its corners are, or when
/// the corners are not convex.
[[nodiscard]] std::optional<IntegerQuad> integer_quad(const ClosedChain& chain,
                                                      const IntegerQuadLimits& limits);

}  // namespace runmark
