#pragma once

#include <vector>

#include "pose/grey_sampler.h"
#include "runmark/board_view.h"

namespace runmark {

/// The inner corners of a ChArUco board, first those beside the markers seen, then outwards from corner to
/// corner.
[[nodiscard]] std::vector<SeenCorner> find_chess_corners(const Board& board,
                                                         const std::vector<SeenMarker>& markers,
                                                         const GreySampler& grey);

}  // namespace runmark
