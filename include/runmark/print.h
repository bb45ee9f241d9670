#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runmark/board.h"
#include "runmark/dictionary.h"
#include "runmark/export.h"
#include "runmark/result.h"

namespace runmark {

/// A sheet of paper. All lengths of this header are in millimetres.
struct Paper {
  double width = 210;
  double height = 297;
  double border = 10;  ///< that a printer may not reach
};

/// A3, A4, A5, Letter, Legal or Tabloid (also "A4-landscape"), or WIDTHxHEIGHT. Errors name these.
[[nodiscard]] RUNMARK_EXPORT Result<Paper> paper(std::string_view name);

/// What is printed besides the markers, and how.
struct PrintStyle {
  double margin_cells = 1;  ///< white round each marker, in its cells; at least 1 is kept
  bool labels = true;       ///< dictionary, id and size beneath each marker, or what a board is
  bool cut_marks = true;    ///< at the corners of each marker's white margin
  bool ruler = true;        ///< at the foot of each page: whether it was printed at true size
  bool inverted = false;    ///< white on black
  int dpi = 300;            ///< of PNG pictures
};

/// A file that was written.
struct PrintedPage {
  std::string path;
  int number = 1;  ///< of the page in its file
};

/// Prints markers at true size: as many on a page as fit, row by row. `path` ends in .pdf, .svg or .png;
/// where there are several pages, those of SVG and PNG become path-1, path-2 and so on.
/// @param size  side of the black square (of the detected square, for AprilTag 3's reversed families)
/// Errors: an id the dictionary does not have, a marker larger than the paper, a file that cannot be written.
[[nodiscard]] RUNMARK_EXPORT Result<std::vector<PrintedPage>> print_markers(const std::string& path,
                                                                            const Dictionary& dictionary,
                                                                            std::span<const int> ids,
                                                                            double size, const Paper& paper,
                                                                            const PrintStyle& style);

/// Prints a grid or a ChArUco board at true size on one page.
/// @param unit  of the board's lengths: 1 when they are in millimetres, 1000 in metres
/// Errors: also a board with markers in space.
[[nodiscard]] RUNMARK_EXPORT Result<std::vector<PrintedPage>> print_board(const std::string& path,
                                                                          const Dictionary& dictionary,
                                                                          const Board& board, double unit,
                                                                          const Paper& paper,
                                                                          const PrintStyle& style);

}  // namespace runmark
