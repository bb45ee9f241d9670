#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "printing/document.h"
#include "printing/drawing.h"
#include "runmark/marker_grid.h"

namespace runmark {
namespace {

constexpr double label_height = 4;
constexpr double between = 6;  // tiles, with room for two cut marks

std::string millimetres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g mm", value);
  return text.data();
}

/// How tiles of one size lie on the pages.
struct Tiling {
  double side = 0;    // of a marker's white margin
  double origin = 0;  // from there to the detected square
  double height = 0;  // with its label
  int columns = 0;
  int rows = 0;
  double left = 0;
  double top = 0;
};

Tiling tile(const Dictionary& dictionary, double size, const Paper& paper, const PrintStyle& style) {
  const MarkerGrid grid = marker_grid(dictionary, 0);
  const double cell = size / dictionary.width;
  const double margin = std::max(style.margin_cells, 1.0);
  Tiling t;
  t.side = (grid.side + 2 * margin) * cell;
  t.origin = (margin - grid.first) * cell;
  t.height = t.side + (style.labels ? label_height : 0);
  const double marks = style.cut_marks ? 3 : 0;
  const double width = paper.width - 2 * paper.border - 2 * marks;
  const double height = paper.height - 2 * paper.border - 2 * marks - (style.ruler ? ruler_height : 0);
  constexpr double slack = 1e-9;
  t.columns = static_cast<int>((width + between + slack) / (t.side + between));
  t.rows = static_cast<int>((height + between + slack) / (t.height + between));
  t.left = (paper.width - (t.columns * (t.side + between) - between)) / 2;
  t.top = paper.border + marks;
  return t;
}

void draw_tile(cairo_t* context, const Dictionary& dictionary, int id, double size, double x, double y,
               const Tiling& t, const PrintStyle& style) {
  if (style.inverted) fill(context, x, y, t.side, t.side, true);
  draw_cells(context, dictionary, id, x + t.origin, y + t.origin, size, false, style.inverted);
  if (style.cut_marks) draw_cut_marks(context, x, y, t.side, t.side);
  if (style.labels) {
    const std::string label = dictionary.name + "  " + std::to_string(id) + "  " + millimetres(size);
    draw_text(context, label, x + t.side / 2, y + t.side + 3.2, 2.8, t.side, Align::middle);
  }
}

}  // namespace

Result<std::vector<PrintedPage>> print_markers(const std::string& path, const Dictionary& dictionary,
                                               std::span<const int> ids, double size, const Paper& paper,
                                               const PrintStyle& style) {
  if (ids.empty()) return Error{"no ids to print"};
  for (const int id : ids) {
    if (id < 0 || static_cast<std::size_t>(id) >= dictionary.codes.size()) {
      return Error{dictionary.name + " has no marker " + std::to_string(id) + "; its ids are 0 to " +
                   std::to_string(dictionary.codes.size() - 1)};
    }
  }
  if (!std::isfinite(size) || size <= 0) return Error{"the size of the markers is not positive"};
  const Tiling t = tile(dictionary, size, paper, style);
  if (t.columns < 1 || t.rows < 1) {
    return Error{"a marker of " + millimetres(size) + " with its white margin is " + millimetres(t.side) +
                 " wide: too large for paper of " + millimetres(paper.width) + " x " +
                 millimetres(paper.height)};
  }
  const auto per_page = static_cast<std::size_t>(t.columns) * static_cast<std::size_t>(t.rows);
  const std::size_t pages = (ids.size() + per_page - 1) / per_page;
  Result<Document> document = Document::create(path, paper, style.dpi, static_cast<int>(pages));
  if (!document) return Error{document.error()};
  std::vector<PrintedPage> printed;
  for (std::size_t page = 0; page < pages; ++page) {
    cairo_t* context = document->begin_page();
    for (std::size_t i = page * per_page; i < std::min(ids.size(), (page + 1) * per_page); ++i) {
      const auto place = static_cast<int>(i - page * per_page);
      draw_tile(context, dictionary, ids[i], size, t.left + place % t.columns * (t.side + between),
                t.top + place / t.columns * (t.height + between), t, style);
    }
    if (style.ruler) draw_ruler(context, paper);
    const Result<PrintedPage> done = document->end_page();
    if (!done) return Error{done.error()};
    printed.push_back(*done);
  }
  return printed;
}

}  // namespace runmark
