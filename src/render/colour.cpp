#include "render/colour.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/rasterise.h"
#include "render/rng.h"

namespace runmark::render {

namespace {

// How much stronger than grey a surface returns red and blue.
std::pair<float, float> tint_of(const Surface& surface, bool wall, std::uint64_t seed) {
  Rng rng(seed);
  const bool bright = rng.chance(0.3);
  const double spread = surface.paper ? 0.03 : wall ? 0.1 : bright ? 0.4 : 0.15;
  const double warmth = rng.uniform(-spread, spread);
  const double other = rng.uniform(-spread, spread) * 0.5;
  return {static_cast<float>(1 + warmth + other), static_cast<float>(1 - warmth + other)};
}

}  // namespace

std::vector<std::uint8_t> colourise(const Scene& scene, const RenderedFrame& frame) {
  Plane red(frame.width, frame.height, 1);
  Plane blue(frame.width, frame.height, 1);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const Surface& surface = scene.surfaces[i];
    const auto [r, b] = tint_of(surface, i == 0, mix(scene.tints + i));
    paint(red, scene.camera, {surface.pose, surface.extent, Gradient{r, r}, 1, false});
    paint(blue, scene.camera, {surface.pose, surface.extent, Gradient{b, b}, 1, false});
  }
  blur(red, scene.optics);
  blur(blue, scene.optics);
  std::vector<std::uint8_t> bgr(3 * frame.grey.size());
  for (std::size_t i = 0; i < frame.grey.size(); ++i) {
    const auto grey = static_cast<float>(frame.grey[i]);
    const int r = std::clamp(static_cast<int>(std::lround(grey * red.values[i])), 0, 255);
    const int b = std::clamp(static_cast<int>(std::lround(grey * blue.values[i])), 0, 255);
    // Green makes up for both, so that the grey is right.
    const int g = std::clamp((256 * frame.grey[i] - 77 * r - 29 * b + 75) / 150, 0, 255);
    bgr[3 * i] = static_cast<std::uint8_t>(b);
    bgr[3 * i + 1] = static_cast<std::uint8_t>(g);
    bgr[3 * i + 2] = static_cast<std::uint8_t>(r);
  }
  return bgr;
}

}  // namespace runmark::render
