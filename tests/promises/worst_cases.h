#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "render/draw_marker.h"
#include "runmark/dictionary.h"
#include "runmark/image_view.h"

namespace runmark::test {

/// A picture made to be hard: as many outlines, long outlines or quadrilaterals as can be.
struct WorstCase {
  std::string name;
  /// Whether pixel (x, y) of a picture of width x height is dark.
  std::function<bool(int x, int y, int width, int height)> dark;
};

/// Dark where the ring of pixels about the frame's edge that (x, y) lies in is one of every `pitch`.
inline bool on_ring(int x, int y, int width, int height, int pitch) {
  return std::min(std::min(x, width - 1 - x), std::min(y, height - 1 - y)) % pitch < pitch / 2;
}

/// Markers side by side, as many as there is room for.
inline WorstCase markers_everywhere() {
  const Dictionary dictionary = *builtin_dictionary("tag36h11");
  std::vector<MarkerDrawing> drawings;
  for (std::size_t id = 0; id < 50; ++id) drawings.push_back(draw_marker(dictionary, id, 2, 1));
  return {"markers everywhere", [drawings](int x, int y, int, int) {
            const int side = drawings[0].side;
            const auto id = static_cast<std::size_t>(x / side * 7 + y / side * 11) % drawings.size();
            return drawings[id].grey[static_cast<std::size_t>(y % side * side + x % side)] < 128;
          }};
}

inline std::vector<WorstCase> worst_cases() {
  const auto noise = [random = std::mt19937(7)](int, int, int, int) mutable { return random() % 2 == 0; };
  return {
      {"checkerboard of 1 px", [](int x, int y, int, int) { return (x + y) % 2 == 0; }},
      {"checkerboard of 4 px", [](int x, int y, int, int) { return (x / 4 + y / 4) % 2 == 0; }},
      {"checkerboard of 9 px", [](int x, int y, int, int) { return (x / 9 + y / 9) % 2 == 0; }},
      {"comb of upright teeth", [](int x, int y, int, int) { return y % 64 < 2 || x % 2 == 0; }},
      {"comb of level teeth", [](int x, int y, int, int) { return x % 64 < 2 || y % 2 == 0; }},
      {"zigzag lines", [](int x, int y, int, int) { return (x + std::abs(y % 8 - 4)) % 4 < 2; }},
      {"slanted lines", [](int x, int y, int, int) { return (x + y) % 4 < 2; }},
      {"spiral",
       [](int x, int y, int width, int height) {
         // Rings of 2 pixels, each opened by a step to the next one.
         const int ring = std::min(std::min(x, width - 1 - x), std::min(y, height - 1 - y));
         const bool step = y == ring && x == ring + 2;
         return (ring / 2 % 2 == 0) != step;
       }},
      {"nested squares", [](int x, int y, int w, int h) { return on_ring(x, y, w, h, 4); }},
      {"small squares", [](int x, int y, int, int) { return x % 12 < 8 && y % 12 < 8; }},
      {"squares in squares", [](int x, int y, int, int) { return on_ring(x % 40, y % 40, 40, 40, 6); }},
      markers_everywhere(),
      {"noise of 50 %", noise},
      {"noise of 50 %, 3 px",
       [](int x, int y, int, int) {
         const auto mixed =
             static_cast<std::uint32_t>(x / 3) * 2654435761U ^ static_cast<std::uint32_t>(y / 3) * 40503U;
         return ((mixed * 2246822519U) >> 16U & 1U) != 0;
       }},
  };
}

struct WorstPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
  [[nodiscard]] ImageView view() const { return ImageView::grey(grey.data(), width, height, width); }
};

inline WorstPicture picture_of(const WorstCase& worst, int width, int height) {
  WorstPicture picture{width, height, {}};
  picture.grey.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture.grey.push_back(worst.dark(x, y, width, height) ? 10 : 245);
  }
  return picture;
}

}  // namespace runmark::test
