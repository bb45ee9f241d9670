#include "runmark/board.h"

#include <algorithm>
#include <cmath>

namespace runmark {
namespace {

constexpr int most_side = 1000;  // columns or rows

std::array<Point3, 4> square_at(double x, double y, double size) {
  return {Point3{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}};
}

bool is_length(double v) { return std::isfinite(v) && v > 0; }

std::optional<Error> check_ids(const Dictionary& dictionary, int first, std::size_t count) {
  const std::size_t last = static_cast<std::size_t>(std::max(first, 0)) + count;
  if (first >= 0 && last <= dictionary.codes.size()) return {};
  return Error{"the board needs the ids " + std::to_string(first) + " to " +
               std::to_string(first + static_cast<long long>(count) - 1) + ", but " + dictionary.name +
               " has " + std::to_string(dictionary.codes.size()) + " markers"};
}

std::optional<Error> check_counts(int columns, int rows, int least, const char* what) {
  if (columns >= least && rows >= least && columns <= most_side && rows <= most_side) return {};
  return Error{std::string("a ") + what + " board has " + std::to_string(least) + " to " +
               std::to_string(most_side) + " columns and rows, not " + std::to_string(columns) + " x " +
               std::to_string(rows)};
}

}  // namespace

Result<Board> grid_board(const Dictionary& dictionary, const GridLayout& layout) {
  if (auto error = check_counts(layout.columns, layout.rows, 1, "grid")) return *error;
  if (!is_length(layout.marker) || !std::isfinite(layout.gap) || layout.gap < 0) {
    return Error{"the markers of a grid board need a positive size, and the gap must not be negative"};
  }
  const std::size_t count = static_cast<std::size_t>(layout.columns) * static_cast<std::size_t>(layout.rows);
  if (auto error = check_ids(dictionary, layout.first_id, count)) return *error;
  Board board;
  board.grid = layout;
  const double pitch = layout.marker + layout.gap;
  for (int row = 0; row < layout.rows; ++row) {
    for (int column = 0; column < layout.columns; ++column) {
      board.markers.push_back({dictionary.name, layout.first_id + row * layout.columns + column,
                               square_at(column * pitch, row * pitch, layout.marker)});
    }
  }
  return board;
}

Result<Board> charuco_board(const Dictionary& dictionary, const CharucoLayout& layout) {
  if (auto error = check_counts(layout.columns, layout.rows, 2, "ChArUco")) return *error;
  if (!is_length(layout.marker) || !is_length(layout.square) || layout.marker >= layout.square) {
    return Error{"the markers of a ChArUco board need a positive size less than that of the squares"};
  }
  Board board;
  board.charuco = layout;
  const double margin = (layout.square - layout.marker) / 2;
  for (int row = 0; row < layout.rows; ++row) {
    for (int column = 0; column < layout.columns; ++column) {
      if (layout.is_black(column, row)) continue;
      auto corners = square_at(column * layout.square + margin, row * layout.square + margin, layout.marker);
      if (layout.turned) std::rotate(corners.begin(), corners.begin() + 2, corners.end());
      board.markers.push_back(
          {dictionary.name, layout.first_id + static_cast<int>(board.markers.size()), corners});
    }
  }
  if (auto error = check_ids(dictionary, layout.first_id, board.markers.size())) return *error;
  for (int row = 1; row < layout.rows; ++row) {
    for (int column = 1; column < layout.columns; ++column) {
      board.chess_corners.push_back({column * layout.square, row * layout.square, 0});
    }
  }
  return board;
}

}  // namespace runmark
