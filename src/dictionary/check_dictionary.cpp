#include "dictionary/check_dictionary.h"

#include <algorithm>

#include "dictionary/cell_rotation.h"
#include "dictionary/code_distance.h"

namespace runmark {

namespace {

std::string text(Cell c) { return std::to_string(c.x) + "," + std::to_string(c.y); }

bool within(Cell c, int low, int high) { return c.x >= low && c.x <= high && c.y >= low && c.y <= high; }

bool may_hold_data(Cell c, Border border, int width) {
  if (border == Border::included) return within(c, 0, width - 1);
  if (within(c, 1, width - 2)) return true;
  // Beyond the white ring and the black ring round it.
  return border == Border::reversed && within(c, -width, 2 * width - 1) && !within(c, -1, width);
}

}  // namespace

std::optional<std::string> check_cells(const Dictionary& dictionary) {
  const auto& cells = dictionary.cells;
  const int inside = dictionary.width - (dictionary.border == Border::included ? 0 : 2);
  if (inside < 2 || inside > max_cells_per_side) {
    return "cells per side must be 2 to " + std::to_string(max_cells_per_side);
  }
  if (cells.empty() || cells.size() > max_data_cells) {
    return std::to_string(cells.size()) + " data cells; there must be 1 to " + std::to_string(max_data_cells);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell c = cells[i];
    if (!may_hold_data(c, dictionary.border, dictionary.width)) {
      return "cell " + text(c) + " is not where this border allows data";
    }
    if (std::ranges::find(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(i), c) !=
        cells.begin() + static_cast<std::ptrdiff_t>(i)) {
      return "cell " + text(c) + " is listed twice";
    }
    const Cell turned = turned_clockwise(c, dictionary.width);
    if (std::ranges::find(cells, turned) == cells.end()) {
      return "cell " + text(c) + " turned by 90 degrees is " + text(turned) + ", which is not a data cell";
    }
  }
  return std::nullopt;
}

std::optional<std::string> check_corrected_bits(const Dictionary& dictionary) {
  if (dictionary.corrected_bits < 0 ||
      (dictionary.corrected_bits > 0 && 2 * dictionary.corrected_bits >= dictionary.distance)) {
    return "cannot correct " + std::to_string(dictionary.corrected_bits) + " bits when codes differ in " +
           std::to_string(dictionary.distance);
  }
  return std::nullopt;
}

std::optional<std::string> check_dictionary(const Dictionary& dictionary) {
  if (auto problem = check_cells(dictionary)) return problem;
  const auto& codes = dictionary.codes;
  if (codes.empty() || codes.size() > max_codes) {
    return std::to_string(codes.size()) + " codes; there must be 1 to " + std::to_string(max_codes);
  }
  const std::size_t bits = dictionary.cells.size();
  for (std::size_t id = 0; id < codes.size(); ++id) {
    if (bits < 64 && codes[id] >> bits != 0) {
      return "code of id " + std::to_string(id) + " has more than " + std::to_string(bits) + " bits";
    }
  }
  if (const auto twice = equal_codes(dictionary)) {
    return "ids " + std::to_string(twice->first) + " and " + std::to_string(twice->second) +
           " have the same code (in some rotation)";
  }
  return check_corrected_bits(dictionary);
}

}  // namespace runmark
