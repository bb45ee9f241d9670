#include "dictionary/cell_rotation.h"

#include <algorithm>

namespace runmark {

CellRotation::CellRotation(std::span<const Cell> cells, int width) : used_((cells.size() + 3) / 4) {
  const std::size_t bits = cells.size();
  for (std::size_t i = 0; i < bits; ++i) {
    const auto found = std::ranges::find(cells, turned_clockwise(cells[i], width));
    if (found == cells.end()) continue;
    const std::size_t source = bits - 1 - static_cast<std::size_t>(found - cells.begin());
    const std::uint64_t target = std::uint64_t{1} << (bits - 1 - i);
    for (std::size_t nibble = 0; nibble < 16; ++nibble) {
      if ((nibble >> (source % 4) & 1U) != 0) tables_[source / 4][nibble] |= target;
    }
  }
}

}  // namespace runmark
