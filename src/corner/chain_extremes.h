#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "contour/chain.h"

namespace runmark {

/// A vertex of a chain's polygon (crack x, crack line y) and its number along the chain: the run i has the
/// vertices 2 i, where it begins, and 2 i + 1, where it ends.
struct NumberedVertex {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t number = 0;
};

/// What the first walk along a chain finds out.
struct ChainExtremes {
  std::array<NumberedVertex, 16> farthest{};  ///< in each of sixteen directions; the first of equals
  std::int64_t area = 0;                      ///< square pixels inside, positive
};

[[nodiscard]] ChainExtremes chain_extremes(const ClosedChain& chain);

/// Four of the sixteen that span a large area, in the order of the chain: the two ends of a long diagonal,
/// then each pair of opposite corners chooses the other, twice. Nothing when two are the same.
[[nodiscard]] std::optional<std::array<NumberedVertex, 4>> widest_corners(const ChainExtremes& extremes);

}  // namespace runmark
