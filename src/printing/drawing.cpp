#include "printing/drawing.h"

#include <algorithm>
#include <cmath>

#include "runmark/marker_grid.h"

namespace runmark {
namespace {

constexpr double hairline = 0.15;

void set_ink(cairo_t* context, bool black) {
  const double level = black ? 0 : 1;
  cairo_set_source_rgb(context, level, level, level);
}

void line(cairo_t* context, double x0, double y0, double x1, double y1) {
  cairo_move_to(context, x0, y0);
  cairo_line_to(context, x1, y1);
}

}  // namespace

void draw_cells(cairo_t* context, const Dictionary& dictionary, int id, double x, double y, double size,
                bool turned, bool inverted) {
  const MarkerGrid grid = marker_grid(dictionary, static_cast<std::size_t>(id));
  const double cell = size / dictionary.width;
  const int last = dictionary.width - 1;
  // One path for all of the cells: separate ones would leave hairlines between neighbours.
  for (int row = grid.first; row < grid.first + grid.side; ++row) {
    int column = grid.first;
    while (column < grid.first + grid.side) {
      const auto is_black = [&](int c) {
        return turned ? !grid.is_white(last - c, last - row) : !grid.is_white(c, row);
      };
      if (!is_black(column)) {
        ++column;
        continue;
      }
      int end = column;
      while (end < grid.first + grid.side && is_black(end)) ++end;
      cairo_rectangle(context, x + column * cell, y + row * cell, (end - column) * cell, cell);
      column = end;
    }
  }
  set_ink(context, !inverted);
  cairo_fill(context);
}

void fill(cairo_t* context, double x, double y, double width, double height, bool black) {
  cairo_rectangle(context, x, y, width, height);
  set_ink(context, black);
  cairo_fill(context);
}

void draw_cut_marks(cairo_t* context, double x, double y, double width, double height) {
  constexpr double gap = 0.5;
  constexpr double length = 2.5;
  set_ink(context, true);
  cairo_set_line_width(context, hairline);
  for (const double side_x : {x, x + width}) {
    const double out = side_x == x ? -1 : 1;
    for (const double side_y : {y, y + height}) {
      const double up = side_y == y ? -1 : 1;
      line(context, side_x + out * gap, side_y, side_x + out * (gap + length), side_y);
      line(context, side_x, side_y + up * gap, side_x, side_y + up * (gap + length));
    }
  }
  cairo_stroke(context);
}

void draw_text(cairo_t* context, const std::string& text, double x, double base, double height,
               double most_width, Align align) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, height);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  if (extents.x_advance > most_width) {
    cairo_set_font_size(context, height * most_width / extents.x_advance);
    cairo_text_extents(context, text.c_str(), &extents);
  }
  set_ink(context, true);
  cairo_move_to(context, align == Align::left ? x : x - extents.x_advance / 2, base);
  cairo_show_text(context, text.c_str());
}

void draw_ruler(cairo_t* context, const Paper& paper) {
  const double room = paper.width - 2 * paper.border - 4;
  const int length = std::min(150, static_cast<int>(room / 10) * 10);
  if (length < 10) return;
  const double x = paper.border + 2;
  const double y = paper.height - paper.border - 4;
  set_ink(context, true);
  cairo_set_line_width(context, hairline);
  line(context, x, y, x + length, y);
  for (int i = 0; i <= length; ++i)
    line(context, x + i, y, x + i, y - (i % 10 == 0 ? 4 : i % 5 == 0 ? 3 : 1.5));
  cairo_stroke(context);
  const std::string text =
      std::to_string(length) + " mm: if it is not so long, print again at 100 %, without 'fit to page'";
  draw_text(context, text, x, y + 3.2, 2.6, paper.width - 2 * paper.border - 2, Align::left);
}

}  // namespace runmark
