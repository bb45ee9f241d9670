#pragma once

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "render/plane.h"
#include "runmark/marker_grid.h"

namespace runmark::render {

// What a surface looks like: each type gives the share of light it returns (0 to 1) at a point of its
// plane. Those for clutter take the unit of the plane as the size of the whole thing or of one repeat.

/// From `a` at v = 0 to `b` at v = 1.
struct Gradient {
  float a = 0.5F;
  float b = 0.5F;
  [[nodiscard]] float value(double u, double v) const;
};

/// Plaster, carpet, foliage: between `a` and `b`, features `size` wide.
struct Noise {
  float a = 0.4F;
  float b = 0.6F;
  double size = 0.1;
  int octaves = 3;
  std::uint32_t seed = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// Tiles or a chessboard: squares of `size`, with joints of `joint` (share of a tile) when not 0.
struct Checker {
  float a = 0.2F;
  float b = 0.8F;
  double size = 0.1;
  double joint = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// Bricks twice as long as high, `size` high, each with a shade of its own, and mortar.
struct Brick {
  float brick = 0.35F;
  float mortar = 0.6F;
  double size = 0.05;
  std::uint32_t seed = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// Boards along u, `size` wide, with grain.
struct Wood {
  float dark = 0.25F;
  float light = 0.5F;
  double size = 0.2;
  std::uint32_t seed = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// Lines of letter-like strokes, `size` from line to line.
struct Text {
  float paper = 0.85F;
  float ink = 0.08F;
  double size = 0.1;
  std::uint32_t seed = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// Upright stripes of random widths and shades between `a` and `b`, about `size` wide: books, blinds.
struct Stripes {
  float a = 0.1F;
  float b = 0.8F;
  double size = 0.1;
  std::uint32_t seed = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// `cells` x `cells` random black and white squares in a black frame one cell wide when `framed`: parts of
/// other codes, which look much like markers and are none.
struct Cells {
  float black = 0.05F;
  float white = 0.85F;
  int cells = 21;
  bool framed = false;
  std::uint32_t seed = 0;
  [[nodiscard]] float value(double u, double v) const;
};

/// A frame with `columns` x `rows` panes: windows, doors, monitors, shelves.
struct Panes {
  float frame = 0.8F;
  float pane = 0.1F;
  int columns = 2;
  int rows = 2;
  double bar = 0.08;  ///< width of frame and bars
  [[nodiscard]] float value(double u, double v) const;
};

/// A grey photo, stretched over the unit square.
struct Photo {
  std::shared_ptr<const Plane> picture;
  [[nodiscard]] float value(double u, double v) const;
};

/// A marker on paper. The unit is a cell; (0, 0) is the top-left corner of the detected square.
struct MarkerPrint {
  MarkerGrid grid;
  float black = 0.06F;
  float white = 0.85F;
  bool inverted = false;
  [[nodiscard]] float value(double u, double v) const;
  /// Whether all of the rectangle has one shade.
  [[nodiscard]] bool plain(double u_low, double u_high, double v_low, double v_high) const;
};

using Texture =
    std::variant<Gradient, Noise, Checker, Brick, Wood, Text, Stripes, Cells, Panes, Photo, MarkerPrint>;

}  // namespace runmark::render
