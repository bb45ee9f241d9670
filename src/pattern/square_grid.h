#pragma once

#include <cstdint>

#include "corner/corner_state_machine.h"

namespace runmark {

/// A pixel by column and row.
struct PixelPosition {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(PixelPosition, PixelPosition) = default;
};

inline constexpr int grid_side = 8;  ///< cells of the paper's grid, border included

/// The paper's sample grid (its section 3.5, in the meaning of docs/design.md): a square built on the edge
/// from corner `a` to corner `b`. With u = b - a and v = (-u_y, u_x) the middle of cell (column, row) is
/// a + (2 column + 1) u / 16 + (2 row + 1) v / 16. Integers only; the pixel that holds that point.
[[nodiscard]] constexpr PixelPosition grid_sample(CrackPoint a, CrackPoint b, int column, int row) {
  const int ux = b.x - a.x;
  const int uy = b.y - a.y;
  const int along = 2 * column + 1;
  const int down = 2 * row + 1;
  return {(16 * a.x + along * ux - down * uy) >> 4, (16 * a.y + along * uy + down * ux) >> 4};
}

}  // namespace runmark
