#include "bench/peers/apriltag_family.h"

#include <algorithm>

namespace runmark::bench {
namespace {

// The cell that a quarter turn clockwise brings there.
Cell turned(Cell cell, int width) { return {static_cast<std::int8_t>(width - 1 - cell.y), cell.x}; }

// Indices of the cells, one from each set of four that are turns of each other, then their turns, then
// the middle cell if there is one.
std::optional<std::vector<std::size_t>> decoder_order(const Dictionary& dictionary) {
  const std::vector<Cell>& cells = dictionary.cells;
  const auto index = [&](Cell cell) {
    return static_cast<std::size_t>(std::ranges::find(cells, cell) - cells.begin());
  };
  std::vector<bool> seen(cells.size(), false);
  std::array<std::vector<std::size_t>, 4> quarters;
  std::vector<std::size_t> middle;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (seen[i]) continue;
    if (turned(cells[i], dictionary.width) == cells[i]) {
      middle.push_back(i);
      continue;
    }
    Cell cell = cells[i];
    for (auto& quarter : quarters) {
      const std::size_t at = index(cell);
      if (at == cells.size()) return std::nullopt;
      seen[at] = true;
      quarter.push_back(at);
      cell = turned(cell, dictionary.width);
    }
  }
  std::vector<std::size_t> order;
  for (const auto& quarter : quarters) order.insert(order.end(), quarter.begin(), quarter.end());
  order.insert(order.end(), middle.begin(), middle.end());
  return order;
}

}  // namespace

std::optional<AprilTagFamily> AprilTagFamily::make(const Dictionary& dictionary) {
  if (dictionary.border == Border::included) return std::nullopt;
  const auto order = decoder_order(dictionary);
  if (!order) return std::nullopt;
  AprilTagFamily made;
  made.name_ = dictionary.name;
  const std::size_t bits = dictionary.cells.size();
  int least = 0;
  int most = dictionary.width - 1;
  for (const std::size_t i : *order) {
    const Cell cell = dictionary.cells[i];
    made.x_.push_back(static_cast<std::uint32_t>(cell.x));  // a negative one comes back as an int
    made.y_.push_back(static_cast<std::uint32_t>(cell.y));
    least = std::min<int>({least, cell.x, cell.y});
    most = std::max<int>({most, cell.x, cell.y});
  }
  for (const std::uint64_t code : dictionary.codes) {
    std::uint64_t reordered = 0;
    for (const std::size_t i : *order) reordered = reordered << 1 | (code >> (bits - 1 - i) & 1U);
    made.codes_.push_back(reordered);
  }
  made.family_.width_at_border = dictionary.width;
  made.family_.total_width = std::max(most - least + 1, dictionary.width + 2);
  made.family_.reversed_border = dictionary.border == Border::reversed;
  made.family_.h = static_cast<std::uint32_t>(dictionary.distance);
  return made;
}

apriltag_family_t* AprilTagFamily::family() {
  family_.ncodes = static_cast<std::uint32_t>(codes_.size());
  family_.codes = codes_.data();
  family_.nbits = static_cast<std::uint32_t>(x_.size());
  family_.bit_x = x_.data();
  family_.bit_y = y_.data();
  family_.name = name_.data();
  return &family_;
}

}  // namespace runmark::bench
