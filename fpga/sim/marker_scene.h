#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "render/draw_marker.h"

namespace runmark::rtl {

struct Scene {
  int width = 0;
  int height = 0;
  int markers = 0;
  std::vector<std::uint8_t> grey;
};

/// Upright markers, up to a few degrees off, on an uneven and noisy ground.
inline Scene make_scene(const Dictionary& dictionary, int width, int height, std::mt19937_64& random) {
  Scene scene{width, height, 0, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height))};
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto at = [&](int x, int y) -> std::uint8_t& {
    return scene.grey[static_cast<std::size_t>(y * width + x)];
  };
  const int speckle = below(3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool spot = speckle > 0 && below(40) == 0;
      at(x, y) = static_cast<std::uint8_t>(spot ? below(256) : 150 + below(100));
    }
  }
  const int cell = 110;
  for (int top = 4; top + cell < height; top += cell) {
    for (int left = 4; left + cell < width; left += cell) {
      const MarkerDrawing drawing = draw_marker(dictionary, random() % dictionary.codes.size(), 1, 1);
      const double size = 3.0 + static_cast<double>(below(50)) / 10;  // pixels a cell
      const double angle = (static_cast<double>(below(81)) - 40) / 10 + 90.0 * below(4);
      const double c = std::cos(angle * 0.017453292519943295) / size;
      const double s = std::sin(angle * 0.017453292519943295) / size;
      for (int y = 0; y < cell; ++y) {
        for (int x = 0; x < cell; ++x) {
          const double dx = x - cell / 2.0;
          const double dy = y - cell / 2.0;
          const double u = c * dx + s * dy + drawing.side / 2.0;
          const double v = c * dy - s * dx + drawing.side / 2.0;
          if (u < 0 || v < 0 || u >= drawing.side || v >= drawing.side) continue;
          const bool white =
              drawing
                  .grey[static_cast<std::size_t>(static_cast<int>(v) * drawing.side + static_cast<int>(u))] !=
              0;
          at(left + x, top + y) = static_cast<std::uint8_t>(white ? 160 + below(90) : 10 + below(90));
        }
      }
      ++scene.markers;
    }
  }
  return scene;
}

}  // namespace runmark::rtl
