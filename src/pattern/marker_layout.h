#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pattern/cell_samples.h"
#include "pattern/light_model.h"
#include "pattern/pattern_picture.h"
#include "runmark/dictionary.h"

namespace runmark {

/// Where the cells of a dictionary's markers lie, and the points at which they are looked at.
struct MarkerLayout {
  /// Points of each data cell in `spread`, well away from its neighbours, against noise.
  static constexpr std::size_t points_a_cell = 5;

  explicit MarkerLayout(const Dictionary& dictionary);
  [[nodiscard]] bool is_of(const Dictionary& dictionary) const;
  [[nodiscard]] bool is_reversed() const { return border == Border::reversed; }

  /// The cells of the marker with this code.
  [[nodiscard]] PatternCells cells_of(std::uint64_t code) const;

  [[nodiscard]] std::size_t memory() const;  ///< bytes beyond its own

  int width;
  Border border;
  std::vector<Cell> cells;  ///< data cells
  int overhang;             ///< cells by which the data reach beyond the square
  BorderRings rings;
  CellPoints middles;  ///< of the data cells
  CellPoints spread;
  CellPoints square;   ///< the middles of all cells of the square, row by row
  CellPoints picture;  ///< picture_places, or none where the square is too wide
};

}  // namespace runmark
