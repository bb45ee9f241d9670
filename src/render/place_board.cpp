#include "render/place_board.h"

#include "runmark/marker_grid.h"

namespace runmark::render {
namespace {

void add_plain(Scene& scene, const PlanePose& pose, const Rectangle& extent, float shade) {
  scene.surfaces.push_back({pose, extent, Gradient{shade, shade}, 1, true});
}

}  // namespace

void place_board(Scene& scene, const Board& board, const Dictionary& dictionary, const PlanePose& pose,
                 const BoardPrint& print) {
  const float paper = print.inverted ? print.black : print.white;
  const float ink = print.inverted ? print.white : print.black;
  double right = 0;
  double bottom = 0;
  double margin = 0;
  if (board.charuco) {
    const CharucoLayout& c = *board.charuco;
    right = c.columns * c.square;
    bottom = c.rows * c.square;
    margin = print.margin * c.square;
  } else if (board.grid) {
    const GridLayout& g = *board.grid;
    right = g.columns * (g.marker + g.gap) - g.gap;
    bottom = g.rows * (g.marker + g.gap) - g.gap;
    margin = print.margin * g.marker;
  }
  add_plain(scene, pose, {-margin, -margin, right + margin, bottom + margin}, paper);
  if (board.charuco) {
    const CharucoLayout& c = *board.charuco;
    for (int row = 0; row < c.rows; ++row) {
      for (int column = 0; column < c.columns; ++column) {
        if (!c.is_black(column, row)) continue;
        add_plain(scene, pose,
                  {column * c.square, row * c.square, (column + 1) * c.square, (row + 1) * c.square}, ink);
      }
    }
  }
  for (const BoardMarker& marker : board.markers) {
    // One cell of the marker is the unit of its own plane.
    const auto& k = marker.corners;
    const double cell_u = (k[1].x - k[0].x) / dictionary.width;
    const double cell_v = (k[3].y - k[0].y) / dictionary.width;
    Surface surface;
    surface.pose = {pose.at(k[0].x, k[0].y), cell_u * pose.along_u, cell_v * pose.along_v};
    const MarkerGrid grid = marker_grid(dictionary, static_cast<std::size_t>(marker.id));
    const double low = grid.first;
    const double high = low + grid.side;
    surface.extent = {low, low, high, high};
    surface.texture = MarkerPrint{grid, print.black, print.white, print.inverted};
    surface.paper = true;
    scene.surfaces.push_back(std::move(surface));
    scene.markers.push_back({scene.surfaces.size() - 1, marker.id, dictionary.width});
  }
}

}  // namespace runmark::render
