#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runmark/dictionary.h"

namespace runmark {

/// A marker drawn upright: a square grey picture, 0 black and 255 white.
struct MarkerDrawing {
  int side = 0;                    ///< pixels along a side of the picture
  int origin = 0;                  ///< pixels left of, and above, the detected square
  int square = 0;                  ///< pixels along a side of the detected square
  std::vector<std::uint8_t> grey;  ///< side * side, row-major
};

/// Draws marker `id` (less than the number of codes) with `pixels_per_cell` >= 1 and `margin_cells` >= 0
/// white cells round all of its cells, those outside the detected square included. With pixel centres at
/// whole numbers the square's corners are at origin - 0.5 and origin + square - 0.5.
[[nodiscard]] MarkerDrawing draw_marker(const Dictionary& dictionary, std::size_t id, int pixels_per_cell,
                                        int margin_cells);

}  // namespace runmark
