#include "pattern/marker_layout.h"

#include <algorithm>
#include <array>

namespace runmark {
namespace {

int overhang_of(const Dictionary& dictionary) {
  int overhang = 0;
  for (const Cell cell : dictionary.cells) overhang = std::max({overhang, -cell.x, -cell.y});
  return overhang;
}

}  // namespace

MarkerLayout::MarkerLayout(const Dictionary& dictionary)
    : width(dictionary.width),
      border(dictionary.border),
      cells(dictionary.cells),
      overhang(overhang_of(dictionary)),
      rings(dictionary.width) {
  constexpr std::array<std::array<double, 2>, points_a_cell> inner{
      {{0.5, 0.5}, {0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}};
  for (const Cell cell : cells) {
    middles.add(cell.x + 0.5, cell.y + 0.5);
    for (const auto& [u, v] : inner) spread.add(cell.x + u, cell.y + v);
  }
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) square.add(x + 0.5, y + 0.5);
  }
  if (width <= PatternCells::most_width) picture = picture_places(width);
}

bool MarkerLayout::is_of(const Dictionary& dictionary) const {
  return width == dictionary.width && border == dictionary.border && cells == dictionary.cells;
}

PatternCells MarkerLayout::cells_of(std::uint64_t code) const {
  constexpr int rim = PatternCells::rim;
  PatternCells pattern(width);
  std::uint64_t left = code << (64 - cells.size());
  for (const Cell cell : cells) {
    const bool white = left >> 63U != 0;
    left <<= 1U;
    const bool kept = cell.x >= -rim && cell.y >= -rim && cell.x < width + rim && cell.y < width + rim;
    if (kept) pattern.at(cell.x, cell.y) = white != is_reversed() ? 1.0F : 0.0F;
  }
  return pattern;
}

std::size_t MarkerLayout::memory() const {
  const std::size_t points =
      rings.points.size() + middles.size() + spread.size() + square.size() + picture.size();
  return cells.size() * sizeof(Cell) + points * 2 * sizeof(float);
}

}  // namespace runmark
