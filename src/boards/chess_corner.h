#pragma once

#include <optional>

#include "pose/grey_sampler.h"
#include "runmark/marker.h"

namespace runmark {

/// Where a corner of a chessboard is to be looked for.
struct CornerGuess {
  Point place;
  Point right;               ///< one square's side to the right, in pixels
  Point down;                ///< and downwards
  double margin = 0;         ///< between the edge of a square and what is drawn in it, as a share of the side
  bool plain_first = false;  ///< nothing is drawn in the squares to the left above and to the right below
  bool inverted = false;     ///< plain squares and drawings are light, not dark
};

struct ChessCorner {
  Point place;
  double deviation = 0;  ///< of x and of y, in pixels
};

/// Fits two crossing edges, blurred alike, to the pixels along them. Where the light sides of an edge change
/// places at the crossing, whatever moves edges into the dark or into the light cancels. Nothing when no such
/// corner is near.
[[nodiscard]] std::optional<ChessCorner> fit_chess_corner(const GreySampler& grey, const CornerGuess& guess);

}  // namespace runmark
