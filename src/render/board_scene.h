#pragma once

#include "render/recipe.h"
#include "render/scene.h"
#include "runmark/board.h"
#include "runmark/dictionary.h"

namespace runmark::render {

/// A view of a flat board.
struct BoardScene {
  Scene scene;
  PlanePose plane;  ///< of the board's frame, exact; its unit is the board's
};

/// The view number `index` of a board by one camera (the recipe's focal length and distortion are drawn once
/// for all views): from all sides, near and far, whole or cut by the picture's edge.
[[nodiscard]] BoardScene make_board_scene(const Recipe& recipe, const Board& board,
                                          const Dictionary& dictionary, std::uint64_t seed, int index);

}  // namespace runmark::render
