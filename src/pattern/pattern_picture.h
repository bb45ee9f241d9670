#pragma once

#include <array>
#include <cstddef>

#include "pattern/cell_samples.h"

namespace runmark {

/// The cells of a marker's square with two more on every side: 0 like the ring inside the square, 1 like the
/// ring outside.
struct PatternCells {
  static constexpr int most_width = 12;  ///< cells across the square
  static constexpr int rim = 2;          ///< cells kept beyond it
  static constexpr int stride = most_width + 2 * rim;

  explicit PatternCells(int cells_across);

  int width;
  std::array<float, std::size_t{stride} * stride> values{};

  /// @param x, y  from -rim to width + rim - 1
  [[nodiscard]] float& at(int x, int y) {
    return values[static_cast<std::size_t>((y + rim) * stride + x + rim)];
  }
  [[nodiscard]] const float* row(int y) const {
    return &values[static_cast<std::size_t>((y + rim) * stride)];
  }
};

/// How the cells of a marker look when a Gaussian blurs them, at every half cell of the square, and how that
/// changes from place to place and with the blur. Along u and along v the places are first the width + 1
/// boundaries of cells, then the width middles.
class PatternPicture {
 public:
  static constexpr int most_places = 2 * PatternCells::most_width + 1;
  using Places = std::array<float, most_places>;

  struct Row {
    Places value;
    Places along;  ///< by u, per cell
    Places down;   ///< by v
    Places by_blur_along;
    Places by_blur_down;
  };

  /// @param blur_along, blur_down  standard deviations along u and v, in cells, from 0.05 to 1
  PatternPicture(const PatternCells& cells, double blur_along, double blur_down);

  /// The places of one v.
  void row(int place, Row& places) const;

 private:
  /// Shares of four cells in the light of a place, and how they change with the place and with the blur. What
  /// lies farther than the four counts as the outer ones.
  struct Shares {
    std::array<float, 4> value;
    std::array<float, 4> slope;
    std::array<float, 4> by_blur;
  };
  static Shares at_boundary(double blur);  ///< from two cells before it on
  static Shares at_middle(double blur);    ///< from one cell before its own on
  using Rows = std::array<Places, PatternCells::stride>;

  int width_;
  Shares down_boundary_;
  Shares down_middle_;
  // Blurred along u only, of every row of cells.
  Rows value_;
  Rows along_;
  Rows by_blur_;
};

/// Where a place lies, in cells.
[[nodiscard]] constexpr double place_at(int place, int width) {
  return place <= width ? place : place - width - 0.5;
}

/// All places of the square, row by row.
[[nodiscard]] CellPoints picture_places(int width);

}  // namespace runmark
