#pragma once

#include <cstdint>

namespace runmark {

/// A run of horizontal cracks between a row and the row above it: the longest stretch of columns
/// [x0, x1) in which the two rows differ in the same sense. This is the contour core's only input.
///
/// Crack x lies between the pixels x - 1 and x; the vertical crack that a run's end touches belongs
/// either to the row above (the boundary comes from there) or to the current row (it goes on there).
struct CrackRun {
  std::uint16_t x0 = 0;
  std::uint16_t x1 = 0;
  bool top = false;          ///< dark below, light above; else dark above, light below
  bool left_above = false;   ///< the end at x0 belongs to the row above
  bool right_above = false;  ///< the end at x1 belongs to the row above
  friend constexpr bool operator==(const CrackRun&, const CrackRun&) = default;
};

}  // namespace runmark
