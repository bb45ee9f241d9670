#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "contour/chain.h"

namespace runmark {

/// A place between pixels: the crack x and the crack line y. Pixel (x, y) has its top-left corner there.
struct CrackPoint {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(CrackPoint, CrackPoint) = default;
};

/// The paper's corner core (its section 3.4): walks the run lengths of a closed chain with saturating
/// counters of the horizontal and vertical offset since the last corner. When the offset across the
/// direction of travel reaches `threshold` pixels there is a corner, the counters start anew and the
/// direction turns towards the offset. A chain with exactly four corners is a candidate.
///
/// The paper puts the corner at the end of the run that reaches the threshold; on a square tilted by a
/// few degrees that is a whole run past the corner, so ours is where that run begins. The chain being
/// closed, it is walked once to learn the direction and once to count.
///
/// Suits near-upright squares only: a side that itself drifts by `threshold` pixels makes a false corner.
/// @return corners in the order of the chain, clockwise in the image
[[nodiscard]] std::optional<std::array<CrackPoint, 4>> four_corners(const ClosedChain& chain, int threshold);

}  // namespace runmark
