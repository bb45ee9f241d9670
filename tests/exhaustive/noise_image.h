#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

#include "pixel_image.h"

namespace runmark {

/// Noise: every block of granularity x granularity pixels is dark with that probability in per cent.
inline PixelImage noise_image(int width, int height, int density, int granularity, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PixelImage image(width, height);
  for (int top = 0; top < height; top += granularity) {
    for (int left = 0; left < width; left += granularity) {
      const bool dark = static_cast<int>(random() % 100) < density;
      for (int y = top; y < std::min(top + granularity, height); ++y) {
        for (int x = left; x < std::min(left + granularity, width); ++x) image.set(x, y, dark);
      }
    }
  }
  return image;
}

}  // namespace runmark
