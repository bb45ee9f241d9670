#include "render/draw_marker.h"

#include <algorithm>

#include "runmark/marker_grid.h"

namespace runmark {

MarkerDrawing draw_marker(const Dictionary& dictionary, std::size_t id, int pixels_per_cell,
                          int margin_cells) {
  const MarkerGrid grid = marker_grid(dictionary, id);
  MarkerDrawing drawing;
  drawing.side = (grid.side + 2 * margin_cells) * pixels_per_cell;
  drawing.origin = (margin_cells - grid.first) * pixels_per_cell;
  drawing.square = dictionary.width * pixels_per_cell;
  drawing.grey.reserve(static_cast<std::size_t>(drawing.side) * static_cast<std::size_t>(drawing.side));
  for (int y = 0; y < drawing.side; ++y) {
    for (int x = 0; x < drawing.side; ++x) {
      const bool white = grid.is_white(x / pixels_per_cell - margin_cells + grid.first,
                                       y / pixels_per_cell - margin_cells + grid.first);
      drawing.grey.push_back(white ? 255 : 0);
    }
  }
  return drawing;
}

}  // namespace runmark
