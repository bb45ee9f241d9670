#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <tuple>
#include <vector>

#include "corner/quad.h"
#include "pattern/square_grid.h"
#include "render/draw_marker.h"
#include "runmark/dictionary.h"
#include "threshold/fixed_threshold.h"

// What the paper's pattern core, in RTL and in HLS C++, is tried with.
namespace runmark::pattern {

inline constexpr int width = 160;
inline constexpr int height = 120;

struct Frame {
  std::vector<std::uint8_t> grey = std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, 200);
  [[nodiscard]] std::uint8_t& at(int x, int y) { return grey[static_cast<std::size_t>(y * width + x)]; }
};

struct QuadIn {
  std::array<CrackPoint, 4> corners{};  // in the order of the chain
  int bottom = 0;
  bool hole = false;
};

struct Settings {
  FixedThreshold threshold{128, false};
  unsigned min_area = 128;  // in half pixels
  unsigned max_area = (1U << 21) - 1;
  int max_errors = 3;
};

struct Found {
  int id = -1, rotation = 0, errors = 0;
  bool hole = false;
  std::array<CrackPoint, 4> corners{};
  friend bool operator==(const Found&, const Found&) = default;
};

/// The definition, as PaperPipeline puts it together.
inline std::optional<Found> plain_match(Frame& frame, const QuadIn& quad, const Settings& settings,
                                        const std::vector<std::uint64_t>& codes) {
  std::array<CrackPoint, 4> c = quad.corners;
  if (quad.hole) std::swap(c[0], c[3]), std::swap(c[1], c[2]);
  Quad shape;
  for (std::size_t i = 0; i < 4; ++i) shape.corners[i] = {c[i].x - 0.5, c[i].y - 0.5};
  const double area = 2 * area_of(shape.corners);
  if (area < settings.min_area || area > settings.max_area || !is_convex_clockwise(shape.corners))
    return std::nullopt;
  std::array<std::array<int, 8>, 8> cell{};
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const PixelPosition p = grid_sample(c[0], c[1], column, row);
      if (p.x < 0 || p.y < 0 || p.x >= width || p.y >= height) return std::nullopt;
      const bool dark = settings.threshold.dark(frame.at(p.x, std::min(p.y, quad.bottom + 1)));
      cell[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = dark != quad.hole ? 0 : 1;
    }
  }
  for (int rotation = 0; rotation < 4; ++rotation) {
    for (std::size_t id = 0; id < codes.size(); ++id) {
      int errors = 0;
      for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
          // Where this cell of the marker as drawn stands after `rotation` quarter turns clockwise.
          int x = column;
          int y = row;
          for (int r = 0; r < rotation; ++r) std::tie(x, y) = std::pair(7 - y, x);
          const bool inner = row > 0 && row < 7 && column > 0 && column < 7;
          const auto bit =
              inner ? static_cast<int>(codes[id] >> (35 - (6 * (row - 1) + column - 1)) & 1U) : 0;
          errors += cell[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] != bit;
        }
      }
      if (errors > settings.max_errors) continue;
      Found found{static_cast<int>(id), rotation, errors, quad.hole, {}};
      for (std::size_t i = 0; i < 4; ++i) found.corners[i] = c[(i + static_cast<std::size_t>(rotation)) % 4];
      return found;
    }
  }
  return std::nullopt;
}

/// A quad to be read in a frame.
struct Case {
  Frame frame;
  QuadIn quad;
  Settings settings;
};

/// A marker in the frame, upright in either colour, with some noise; the quad is around it, near it or
/// anywhere.
inline Case random_case(int number, const Dictionary& dictionary, std::size_t codes,
                        std::mt19937_64& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Case it;
  const MarkerDrawing drawing = draw_marker(dictionary, random() % codes, 1 + below(8), 0);
  const int side = drawing.side;
  const int x0 = 1 + below(width - side - 2);
  const int y0 = 1 + below(height - side - 2);
  const int turn = below(4);
  const bool inverted = below(4) == 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      int px = x;
      int py = y;
      for (int r = 0; r < turn; ++r) std::tie(px, py) = std::pair(side - 1 - py, px);
      const int level =
          drawing.grey[static_cast<std::size_t>(y * side + x)] != 0 ? 150 + below(100) : below(110);
      it.frame.at(x0 + px, y0 + py) = static_cast<std::uint8_t>(inverted ? 255 - level : level);
    }
  }
  for (int n = below(12); n > 0; --n)
    it.frame.at(below(width), below(height)) = static_cast<std::uint8_t>(below(256));
  QuadIn& quad = it.quad;
  quad.corners = {CrackPoint{x0, y0}, {x0 + side, y0}, {x0 + side, y0 + side}, {x0, y0 + side}};
  std::rotate(quad.corners.begin(), quad.corners.begin() + below(4), quad.corners.end());
  if (number % 3 == 0) {
    const auto moved = [&](int at, int most) { return std::clamp(at + below(9) - 4, 0, most - 1); };
    for (CrackPoint& c : quad.corners) c = {moved(c.x, width), moved(c.y, height)};
  }
  if (number % 50 == 0) {
    for (CrackPoint& c : quad.corners) c = {below(width), below(height)};
  }
  quad.hole = inverted;
  if (quad.hole) std::swap(quad.corners[0], quad.corners[3]), std::swap(quad.corners[1], quad.corners[2]);
  quad.bottom = std::min(y0 + side + below(3), height - 1);
  Settings& settings = it.settings;
  settings.max_errors = below(6);
  settings.threshold.above_is_dark = below(5) == 0;
  if (number % 7 == 0) settings.min_area = static_cast<unsigned>(below(6000));
  if (number % 11 == 0) settings.max_area = static_cast<unsigned>(below(6000));
  return it;
}

}  // namespace runmark::pattern
