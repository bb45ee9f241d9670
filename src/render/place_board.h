#pragma once

#include "render/scene.h"
#include "runmark/board.h"
#include "runmark/dictionary.h"

namespace runmark::render {

/// How a board is printed.
struct BoardPrint {
  float black = 0.06F;
  float white = 0.85F;
  double margin = 0.5;  ///< paper round it, in squares of a ChArUco board, in markers of a grid
  bool inverted = false;
};

/// Adds a flat board (a grid or a ChArUco board, in its own unit) to the scene. `pose` is that of the board's
/// frame; its vectors have the length of the board's unit. The board's markers become the scene's.
void place_board(Scene& scene, const Board& board, const Dictionary& dictionary, const PlanePose& pose,
                 const BoardPrint& print);

}  // namespace runmark::render
