#include "sheet.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "dictionary/cell_rotation.h"
#include "render/draw_marker.h"

namespace runmark {

namespace {

bool close(const std::array<Point, 4>& a, const std::array<Point, 4>& b, std::size_t turn, double tolerance) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = b[(i + turn) % 4];
    if (std::hypot(a[i].x - p.x, a[i].y - p.y) > tolerance) return false;
  }
  return true;
}

}  // namespace

Sheet draw_sheet(const Dictionary& dictionary, std::size_t first_id, int pixels_per_cell, int margin_cells) {
  constexpr int about = 2000;
  const int pitch = draw_marker(dictionary, first_id, pixels_per_cell, margin_cells).side;
  const auto columns = static_cast<std::size_t>(about / pitch);
  Sheet sheet;
  sheet.side = static_cast<int>(columns) * pitch;
  const auto width = static_cast<std::size_t>(sheet.side);
  sheet.grey.assign(width * width, 255);
  const std::size_t end = std::min(dictionary.codes.size(), first_id + columns * columns);
  for (std::size_t id = first_id; id < end; ++id) {
    const MarkerDrawing drawing = draw_marker(dictionary, id, pixels_per_cell, margin_cells);
    const std::size_t x = (id - first_id) % columns * static_cast<std::size_t>(pitch);
    const std::size_t y = (id - first_id) / columns * static_cast<std::size_t>(pitch);
    for (std::size_t row = 0; row < static_cast<std::size_t>(pitch); ++row) {
      std::copy_n(&drawing.grey[row * static_cast<std::size_t>(pitch)], pitch,
                  &sheet.grey[(y + row) * width + x]);
    }
    const double left = static_cast<double>(x) + drawing.origin - 0.5;
    const double top = static_cast<double>(y) + drawing.origin - 0.5;
    const double right = left + drawing.square;
    const double bottom = top + drawing.square;
    sheet.markers.push_back(
        {static_cast<int>(id), {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}}});
  }
  return sheet;
}

std::vector<std::string> mistakes(const Sheet& sheet, const std::vector<Reading>& readings,
                                  const Dictionary& dictionary, double tolerance) {
  std::vector<std::string> problems;
  const CellRotation rotation(dictionary.cells, dictionary.width);
  for (const Sheet::Drawn& marker : sheet.markers) {
    const std::string name = dictionary.name + " id " + std::to_string(marker.id);
    const auto count = std::ranges::count(readings, marker.id, &Reading::id);
    if (count != 1) {
      problems.push_back(name + " was read " + std::to_string(count) + " times");
      continue;
    }
    const Reading& reading = *std::ranges::find(readings, marker.id, &Reading::id);
    const bool symmetric = rotation.is_own(dictionary.codes[static_cast<std::size_t>(marker.id)]);
    bool found = false;
    for (std::size_t turn = 0; turn < (symmetric ? 4 : 1); ++turn) {
      found = found || close(marker.corners, reading.corners, turn, tolerance);
    }
    if (!found) problems.push_back(name + ": a corner is in another place");
  }
  if (readings.size() != sheet.markers.size()) {
    problems.push_back(std::to_string(readings.size()) + " readings of " +
                       std::to_string(sheet.markers.size()));
  }
  return problems;
}

}  // namespace runmark
