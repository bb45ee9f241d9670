#include "render/texture.h"

#include <algorithm>
#include <cmath>

#include "render/noise_field.h"

namespace runmark::render {

namespace {

float blend(float a, float b, float t) { return a + (b - a) * t; }
double fraction(double x) { return x - floor_int(x); }

}  // namespace

float Gradient::value(double /*u*/, double v) const {
  return blend(a, b, static_cast<float>(std::clamp(v, 0.0, 1.0)));
}

float Noise::value(double u, double v) const {
  return blend(a, b, fractal_noise(u / size, v / size, octaves, seed));
}

float Checker::value(double u, double v) const {
  const double x = u / size;
  const double y = v / size;
  if (joint > 0 && (fraction(x) < joint || fraction(y) < joint)) return a;
  if (joint > 0) return b * (0.9F + 0.2F * lattice_value(floor_int(x), floor_int(y), 77));
  return ((floor_int(x) + floor_int(y)) & 1) != 0 ? a : b;
}

float Brick::value(double u, double v) const {
  const double y = v / size;
  const int course = floor_int(y);
  const double x = u / (2 * size) + 0.5 * (course & 1);
  if (fraction(y) < 0.14 || fraction(x) < 0.07) return mortar;
  return brick * (0.7F + 0.6F * lattice_value(floor_int(x), course, seed));
}

float Wood::value(double u, double v) const {
  const double y = v / size;
  const int board = floor_int(y);
  if (fraction(y) < 0.02) return dark * 0.5F;
  const auto board_seed = seed + static_cast<std::uint32_t>(board) * 7919U;
  const float shade = lattice_value(board, 3, seed);
  const float grain = smooth_noise(u * 2 / size, y * 24, board_seed);
  const float fine = smooth_noise(u * 8 / size, y * 70, board_seed + 1);
  return blend(dark, light, 0.4F * shade + 0.4F * grain + 0.2F * fine);
}

float Text::value(double u, double v) const {
  const double y = v / size;
  const int line = floor_int(y);
  const double within = fraction(y);
  if (within < 0.25 || within > 0.8) return paper;
  const double x = u / (0.4 * size);  // a letter and its gap
  const int letter = floor_int(x);
  // Words of a few letters, and lines of different lengths.
  if (lattice_value(letter, line, seed) < 0.18F) return paper;
  if (static_cast<float>(u) > 1 - 0.35F * lattice_value(line, 1, seed + 1)) return paper;
  const double across = fraction(x);
  if (across > 0.75) return paper;
  // Each letter is some of the strokes of a seven-segment digit.
  const double down = (within - 0.25) / 0.55;
  const auto stroke = [&](int n) { return lattice_value(letter * 8 + n, line, seed + 2) < 0.6F; };
  const bool left = across < 0.2;
  const bool right = across > 0.55;
  if (left && stroke(down < 0.5 ? 0 : 1)) return ink;
  if (right && stroke(down < 0.5 ? 2 : 3)) return ink;
  if (down < 0.17 && stroke(4)) return ink;
  if (down > 0.42 && down < 0.58 && stroke(5)) return ink;
  if (down > 0.83 && stroke(6)) return ink;
  return paper;
}

float Stripes::value(double u, double /*v*/) const {
  // Pairs of stripes whose common border wanders.
  const double x = u / size;
  const int pair = floor_int(x / 2);
  const float border = 0.5F + lattice_value(pair, 0, seed);
  const int stripe = 2 * pair + (static_cast<float>(x - 2 * pair) > border ? 1 : 0);
  return blend(a, b, lattice_value(stripe, 1, seed));
}

float Cells::value(double u, double v) const {
  const int n = cells + (framed ? 2 : 0);
  const int x = floor_int(u * n);
  const int y = floor_int(v * n);
  if (framed && (x <= 0 || y <= 0 || x >= n - 1 || y >= n - 1)) return black;
  return lattice_value(x, y, seed) < 0.5F ? black : white;
}

float Panes::value(double u, double v) const {
  const double x = u * (1 - bar);
  const double y = v * (1 - bar);
  const double column = (1 - bar) / columns;
  const double row = (1 - bar) / rows;
  if (u > 1 - bar || v > 1 - bar) return frame;
  if (std::fmod(std::max(0.0, x), column) < bar || std::fmod(std::max(0.0, y), row) < bar) return frame;
  return pane;
}

float Photo::value(double u, double v) const {
  const double x = std::clamp(u * picture->width - 0.5, 0.0, picture->width - 1.0);
  const double y = std::clamp(v * picture->height - 0.5, 0.0, picture->height - 1.0);
  const int x0 = std::min(floor_int(x), std::max(0, picture->width - 2));
  const int y0 = std::min(floor_int(y), std::max(0, picture->height - 2));
  const int x1 = std::min(x0 + 1, picture->width - 1);
  const int y1 = std::min(y0 + 1, picture->height - 1);
  const auto tx = static_cast<float>(x - x0);
  const auto ty = static_cast<float>(y - y0);
  const float* top = picture->row(y0);
  const float* bottom = picture->row(y1);
  return blend(blend(top[x0], top[x1], tx), blend(bottom[x0], bottom[x1], tx), ty);
}

float MarkerPrint::value(double u, double v) const {
  return grid.is_white(floor_int(u), floor_int(v)) != inverted ? white : black;
}

bool MarkerPrint::plain(double u_low, double u_high, double v_low, double v_high) const {
  // Cells beyond the grid are all alike: clamp, so that a wide margin costs nothing.
  const auto clamp = [this](double x) {
    return std::clamp(floor_int(x), grid.first - 1, grid.first + grid.side);
  };
  const int x0 = clamp(u_low);
  const int x1 = clamp(u_high);
  const int y0 = clamp(v_low);
  const int y1 = clamp(v_high);
  const bool first = grid.is_white(x0, y0);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (grid.is_white(x, y) != first) return false;
    }
  }
  return true;
}

}  // namespace runmark::render
