#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runmark/dictionary.h"
#include "runmark/export.h"

namespace runmark {

/// Every cell of a marker as it is drawn, border and data beyond it included.
struct MarkerGrid {
  int first = 0;  ///< x and y of the first cell: 0, or less when cells lie outside the square
  int side = 0;   ///< cells along a side
  std::vector<std::uint8_t> white;  ///< side * side, row-major: 1 is white, 0 black

  /// Cell (x, y), counted from the top-left corner of the detected square; white beyond the grid.
  [[nodiscard]] bool is_white(int x, int y) const {
    const int column = x - first;
    const int row = y - first;
    if (column < 0 || row < 0 || column >= side || row >= side) return true;
    return white[static_cast<std::size_t>(row * side + column)] != 0;
  }
};

/// The grid of marker `id`, which must be less than the number of codes. Cells that hold neither border
/// nor data are black inside the square and white outside.
[[nodiscard]] RUNMARK_EXPORT MarkerGrid marker_grid(const Dictionary& dictionary, std::size_t id);

}  // namespace runmark
