#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "printing/document.h"
#include "printing/drawing.h"

namespace runmark {
namespace {

constexpr double label_height = 4;
constexpr double marks = 3;

struct Extent {
  double width = 0;
  double height = 0;
  double margin = 0;
};

Extent extent_of(const Board& board, const Dictionary& dictionary, double unit, const PrintStyle& style) {
  const double cells = std::max(style.margin_cells, 1.0) / dictionary.width;
  if (board.charuco) {
    const CharucoLayout& c = *board.charuco;
    return {c.columns * c.square * unit, c.rows * c.square * unit, cells * c.marker * unit};
  }
  const GridLayout& g = *board.grid;
  const auto side = [&](int count) { return (count * (g.marker + g.gap) - g.gap) * unit; };
  return {side(g.columns), side(g.rows), cells * g.marker * unit};
}

std::string description(const Board& board, const Dictionary& dictionary, double unit) {
  std::array<char, 200> text{};
  if (board.charuco) {
    const CharucoLayout& c = *board.charuco;
    std::snprintf(text.data(), text.size(),
                  "ChArUco %d x %d, square %.6g mm, marker %.6g mm, ids from %d%s%s", c.columns, c.rows,
                  c.square * unit, c.marker * unit, c.first_id, c.legacy ? ", layout before OpenCV 4.6" : "",
                  c.turned ? ", markers turned" : "");
  } else {
    const GridLayout& g = *board.grid;
    std::snprintf(text.data(), text.size(), "grid %d x %d, marker %.6g mm, gap %.6g mm, ids from %d",
                  g.columns, g.rows, g.marker * unit, g.gap * unit, g.first_id);
  }
  return dictionary.name + "  " + text.data();
}

void draw_board(cairo_t* context, const Board& board, const Dictionary& dictionary, double unit, double left,
                double top, bool inverted) {
  if (board.charuco) {
    const CharucoLayout& c = *board.charuco;
    const double square = c.square * unit;
    for (int row = 0; row < c.rows; ++row) {
      for (int column = 0; column < c.columns; ++column) {
        if (!c.is_black(column, row)) continue;
        // One path for all squares, as for the cells of a marker.
        cairo_rectangle(context, left + column * square, top + row * square, square, square);
      }
    }
    const double level = inverted ? 1 : 0;
    cairo_set_source_rgb(context, level, level, level);
    cairo_fill(context);
  }
  for (const BoardMarker& marker : board.markers) {
    const auto [x0, x1] = std::minmax(marker.corners[0].x, marker.corners[2].x);
    const double y0 = std::min(marker.corners[0].y, marker.corners[2].y);
    draw_cells(context, dictionary, marker.id, left + x0 * unit, top + y0 * unit, (x1 - x0) * unit,
               marker.corners[0].x > marker.corners[1].x, inverted);
  }
}

}  // namespace

Result<std::vector<PrintedPage>> print_board(const std::string& path, const Dictionary& dictionary,
                                             const Board& board, double unit, const Paper& paper,
                                             const PrintStyle& style) {
  if (!board.charuco && !board.grid) return Error{"only grids and ChArUco boards can be printed"};
  for (const BoardMarker& marker : board.markers) {
    if (marker.id < 0 || static_cast<std::size_t>(marker.id) >= dictionary.codes.size()) {
      return Error{dictionary.name + " has no marker " + std::to_string(marker.id)};
    }
  }
  if (!std::isfinite(unit) || unit <= 0) return Error{"the unit of the board is not positive"};
  const Extent e = extent_of(board, dictionary, unit, style);
  const double border = paper.border + (style.cut_marks ? marks : 0);
  const double foot = (style.ruler ? ruler_height : 0) + (style.labels ? label_height : 0);
  const double width = e.width + 2 * e.margin;
  const double height = e.height + 2 * e.margin;
  if (width > paper.width - 2 * border + 1e-9 || height > paper.height - 2 * border - foot + 1e-9) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "the board with its white margin is %.6g x %.6g mm: too large for paper of %.6g x %.6g mm",
                  width, height, paper.width, paper.height);
    return Error{text.data()};
  }
  Result<Document> document = Document::create(path, paper, style.dpi, 1);
  if (!document) return Error{document.error()};
  cairo_t* context = document->begin_page();
  const double left = (paper.width - width) / 2;
  const double top = border;
  if (style.inverted) fill(context, left, top, width, height, true);
  draw_board(context, board, dictionary, unit, left + e.margin, top + e.margin, style.inverted);
  if (style.cut_marks) draw_cut_marks(context, left, top, width, height);
  if (style.labels) {
    draw_text(context, description(board, dictionary, unit), paper.width / 2, top + height + 3.4, 2.8,
              paper.width - 2 * paper.border, Align::middle);
  }
  if (style.ruler) draw_ruler(context, paper);
  const Result<PrintedPage> done = document->end_page();
  if (!done) return Error{done.error()};
  return std::vector{*done};
}

}  // namespace runmark
