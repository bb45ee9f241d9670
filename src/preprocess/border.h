#pragma once

#include <algorithm>
#include <cstddef>

#include "preprocess/bit_row.h"

namespace runmark {

/// Makes the image's outermost pixels light, so that every contour closes inside the image: the first and
/// last pixel of every row, all of the first and the last row. Laid before the filter, which keeps it.
/// @param y  number of the row, of `height` in all
constexpr void clear_border(BitWord* row, int width, int y, int height) {
  if (width <= 2 || y == 0 || y == height - 1) {
    std::fill_n(row, bit_words(width), BitWord{0});
    return;
  }
  set_bit(row, 0, false);
  set_bit(row, width - 1, false);
}

}  // namespace runmark
