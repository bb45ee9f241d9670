#pragma once

#include <cairo.h>

#include <string>

#include "runmark/dictionary.h"
#include "runmark/print.h"

namespace runmark {

// All in millimetres.

/// The cells of a marker whose detected square has its top-left corner at (x, y); `turned` puts it on its
/// head. The paper must already have the colour of its light cells, or its dark ones when inverted.
void draw_cells(cairo_t* context, const Dictionary& dictionary, int id, double x, double y, double size,
                bool turned, bool inverted);

void fill(cairo_t* context, double x, double y, double width, double height, bool black);

/// Ticks outside the four corners of a rectangle.
void draw_cut_marks(cairo_t* context, double x, double y, double width, double height);

/// A line of text whose middle, or left end, is at x and whose base is at y; made smaller where it would be
/// wider than `most_width`.
enum class Align { left, middle };
void draw_text(cairo_t* context, const std::string& text, double x, double base, double height,
               double most_width, Align align);

/// A ruler of whole centimetres along the foot of the page.
void draw_ruler(cairo_t* context, const Paper& paper);

/// How much of the page's foot the ruler needs.
inline constexpr double ruler_height = 12;

}  // namespace runmark
