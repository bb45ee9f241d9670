#pragma once

#include <string_view>

#include "marker_scene.h"
#include "render/recipe.h"
#include "render/standard_sets.h"

namespace runmark::rtl {

/// Scene `index` of a standard set of rendered scenes, or of `vga` at another size.
inline Scene rendered_scene(std::string_view set, const Dictionary& dictionary, int index, int width = 0,
                            int height = 0) {
  render::Recipe recipe = render::find_standard_set(set)->recipe;
  if (width != 0) recipe.width = width;
  if (height != 0) recipe.height = height;
  auto frame = render::render(render::make_scene(recipe, dictionary, render::set_seed(set, 0), index));
  return {frame.width, frame.height, static_cast<int>(frame.truth.markers.size()), std::move(frame.grey)};
}

/// A frame of the paper's load, about 2,970 run lengths in 70 segments: markers as the camera of the paper
/// sees them, nearly upright, and round dark spots.
inline Scene paper_load_scene(const Dictionary& dictionary) {
  Scene scene{640, 480, 0, std::vector<std::uint8_t>(640UL * 480UL, 220)};
  const auto at = [&](int x, int y) -> std::uint8_t& {
    return scene.grey[static_cast<std::size_t>(y * scene.width + x)];
  };
  for (int k = 0; k < 3; ++k) {
    const MarkerDrawing drawing = draw_marker(dictionary, static_cast<std::size_t>(k), 1, 1);
    const double size = 14;  // pixels a cell
    const double angle = 0.03;
    const double middle_x = 110 + 210 * k;
    const double middle_y = 110;
    for (int y = 10; y < 210; ++y) {
      for (int x = 210 * k + 10; x < 210 * k + 210; ++x) {
        const double u = ((x - middle_x) * std::cos(angle) + (y - middle_y) * std::sin(angle)) / size;
        const double v = ((y - middle_y) * std::cos(angle) - (x - middle_x) * std::sin(angle)) / size;
        const double cu = u + drawing.side / 2.0;
        const double cv = v + drawing.side / 2.0;
        if (cu < 0 || cv < 0 || cu >= drawing.side || cv >= drawing.side) continue;
        const auto cell =
            static_cast<std::size_t>(static_cast<int>(cv) * drawing.side + static_cast<int>(cu));
        if (drawing.grey[cell] == 0) at(x, y) = 30;
      }
    }
    ++scene.markers;
  }
  const int spots = 51;
  for (int k = 0; k < spots; ++k) {
    const int radius = k < 20 ? 23 : 22;
    const int middle_x = 32 + (k % 13) * 48;
    const int middle_y = 255 + (k / 13) * 56;
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        if (x * x + y * y <= radius * radius) at(middle_x + x, middle_y + y) = 30;
      }
    }
  }
  return scene;
}

/// Slanted stripes, each a pixel further right in every row: 2 / period run lengths for every pixel of a
/// row, which is the paper's worst case of N / 3 at period 6; the filter closes narrower gaps than those of
/// period 4.
inline Scene striped_scene(int width, int height, int period) {
  Scene scene{width, height, 0, {}};
  scene.grey.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      scene.grey.push_back(((x - y) % period + period) % period < (period + 1) / 2 ? 30 : 220);
    }
  }
  return scene;
}

}  // namespace runmark::rtl
