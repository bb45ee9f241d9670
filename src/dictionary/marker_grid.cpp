#include "runmark/marker_grid.h"

#include <algorithm>

namespace runmark {

MarkerGrid marker_grid(const Dictionary& dictionary, std::size_t id) {
  const int width = dictionary.width;
  const bool reversed = dictionary.border == Border::reversed;
  int first = reversed ? -1 : 0;
  for (const Cell c : dictionary.cells) first = std::min({first, int{c.x}, int{c.y}});

  MarkerGrid grid{first, width - 2 * first, {}};
  grid.white.assign(static_cast<std::size_t>(grid.side) * static_cast<std::size_t>(grid.side), 1);
  const auto set = [&](int x, int y, bool white) {
    grid.white[static_cast<std::size_t>((y - first) * grid.side + x - first)] = white ? 1 : 0;
  };
  const auto fill = [&](int low, int high, bool white) {
    for (int y = low; y <= high; ++y) {
      for (int x = low; x <= high; ++x) set(x, y, white);
    }
  };
  if (reversed) {
    fill(-1, width, false);
    fill(0, width - 1, true);
    fill(1, width - 2, false);
  } else {
    fill(0, width - 1, false);
  }
  const std::size_t bits = dictionary.cells.size();
  for (std::size_t i = 0; i < bits; ++i) {
    const Cell c = dictionary.cells[i];
    set(c.x, c.y, (dictionary.codes[id] >> (bits - 1 - i) & 1U) != 0);
  }
  return grid;
}

}  // namespace runmark
