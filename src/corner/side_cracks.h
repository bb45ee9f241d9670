#pragma once

#include <cstddef>

#include "corner/line_fit.h"
#include "corner/outline.h"

namespace runmark {

/// The way along one side of an outline, from corner to corner, and what of it counts. Distances along it and
/// across it stand times its length, as products with `along` give them: whole numbers.
struct SideWay {
  Point start{};    ///< the first corner's crack_point
  Point along{};    ///< from the first corner to the next
  double low = 0;   ///< cracks count from here on
  double high = 0;  ///< to here
  double band = 0;  ///< and no farther across than this
};

/// What the cracks of a side tell.
struct SideCracks {
  LineFit fit;
  double covered = 0;  ///< how far they lead along the way
};

/// The cracks from one vertex of the outline to another that count for the way. The sums are exact
/// wherever a run lies wholly inside, so that the order in which vectors add does not show; what is cut off
/// at `low` and `high` is added in the order of the outline.
/// @param outline  its first vertex stands once more behind its last
[[nodiscard]] SideCracks side_cracks(const Outline& outline, std::size_t from, std::size_t to,
                                     const SideWay& way);

}  // namespace runmark
