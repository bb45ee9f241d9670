#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "runmark/dictionary.h"
#include "runmark/export.h"
#include "runmark/point3.h"
#include "runmark/result.h"

namespace runmark {

/// A marker's place on a board.
struct BoardMarker {
  std::string dictionary;  ///< as its markers are reported; empty: any
  int id = -1;
  std::array<Point3, 4>
      corners{};  ///< top-left, top-right, bottom-right, bottom-left as drawn, in the board's frame
};

/// Rows of markers of one size.
struct GridLayout {
  int columns = 0;
  int rows = 0;
  double marker = 0;  ///< side of a marker, in the board's unit
  double gap = 0;     ///< between two of them
  int first_id = 0;   ///< of the top-left one; ids go on row by row
};

/// A chessboard with a marker in each white square (ChArUco). The inner corners of the chessboard are
/// numbered from 0, row by row, from the top left one on.
struct CharucoLayout {
  int columns = 0;    ///< squares
  int rows = 0;       ///< squares
  double square = 0;  ///< side of a square, in the board's unit
  double marker = 0;  ///< side of a marker
  int first_id = 0;
  /// The layout of OpenCV before 4.6: with an even number of rows the top-left square is white.
  bool legacy = false;
  /// The markers stand on their heads, as where OpenCV 4 prints its AprilTag dictionaries.
  bool turned = false;

  /// Whether the square in that column and row is black.
  [[nodiscard]] constexpr bool is_black(int column, int row) const {
    const bool white_first = legacy && rows % 2 == 0;
    return ((column + row) % 2 != 0) == white_first;
  }
};

/// Markers whose places are known relative to each other, in one frame and one unit. In the frame of a grid
/// and of a ChArUco board the origin is the board's top-left corner, x goes right, y down and z into the
/// sheet, as in OpenCV since 4.6. A ChArUco board's corner is that of its first square, a grid's that of its
/// first marker.
struct Board {
  std::vector<BoardMarker> markers;
  std::vector<Point3> chess_corners;     ///< of a ChArUco board: the inner corners of the chessboard
  std::optional<CharucoLayout> charuco;  ///< what it was made of
  std::optional<GridLayout> grid;        ///< likewise
};

/// Errors: no columns or rows, sizes that do not fit, more markers than the dictionary has.
[[nodiscard]] RUNMARK_EXPORT Result<Board> grid_board(const Dictionary& dictionary, const GridLayout& layout);
[[nodiscard]] RUNMARK_EXPORT Result<Board> charuco_board(const Dictionary& dictionary,
                                                         const CharucoLayout& layout);

}  // namespace runmark
