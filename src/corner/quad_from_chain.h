#pragma once

#include <cstdint>
#include <optional>

#include "contour/chain.h"
#include "corner/outline.h"
#include "corner/quad.h"

namespace runmark {

/// What a chain must be like to become a candidate. Lengths in pixels of its octave.
struct QuadLimits {
  double min_area = 25;
  double max_area = 1e12;
  double min_side = 3;
};

/// Room for the vertices of the longest chain the linker hands on.
[[nodiscard]] constexpr std::size_t max_vertices(const ChainLimits& limits) {
  return 2 * static_cast<std::size_t>(limits.max_records);
}

/// Finds the quadrilateral a closed chain draws, at any rotation: the four vertices that span the largest
/// area, then a line fitted to the cracks of each side, then the points where neighbouring lines meet.
/// Nothing when the chain's area differs from the quadrilateral's, when a side is not straight or when
/// the corners are not convex.
/// @param outline  scratch with room for max_vertices
[[nodiscard]] std::optional<Quad> quad_from_chain(const ClosedChain& chain, const QuadLimits& limits,
                                                  Outline& outline);

}  // namespace runmark
