#pragma once

#include <cstdint>
#include <span>

#include "runmark/dictionary.h"

namespace runmark {

inline constexpr int most_cells_across = 16;

/// Grey values at the middles of a marker's cells, border included: values[y * width + x].
struct CellValues {
  int width = 0;
  float values[most_cells_across * most_cells_across] = {};
  [[nodiscard]] float& at(int x, int y) { return values[y * width + x]; }
  [[nodiscard]] float at(int x, int y) const { return values[y * width + x]; }
};

/// What a blurred marker's cells were before blur: those that explain its values best.
struct Unblurred {
  std::uint64_t code = 0;  ///< cells[0] is the most significant bit; 1 like the ring outside the square
  float margin = 0;        ///< as Marker::margin
};

/// The share of a cell's light that a Gaussian blur of that standard deviation, in cells, moves into the
/// next.
[[nodiscard]] float spill(double blur);

/// Looks for the cells whose blurred picture is nearest to `values`, black and white level by least squares:
/// first for any greys, one cell after the other, then rounded, and then every cell is turned over that
/// brings the picture nearer. Cells in the border are 0 and those outside 1. No margin where the values show
/// too little contrast.
/// @param across, down  share of a cell's light that blur moves into the next cell, on either side
[[nodiscard]] Unblurred unblur(const CellValues& values, std::span<const Cell> cells, float across,
                               float down);

}  // namespace runmark
