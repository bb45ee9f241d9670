#include "render/jpeg_damage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/maths.h"

namespace runmark::render {

namespace {

using Block = std::array<float, 64>;

// ITU-T T.81, table K.1.
constexpr std::array<int, 64> luminance{16, 11, 10, 16, 24,  40,  51,  61,   //
                                        12, 12, 14, 19, 26,  58,  60,  55,   //
                                        14, 13, 16, 24, 40,  57,  69,  56,   //
                                        14, 17, 22, 29, 51,  87,  80,  62,   //
                                        18, 22, 37, 56, 68,  109, 103, 77,   //
                                        24, 35, 55, 64, 81,  104, 113, 92,   //
                                        49, 64, 78, 87, 103, 121, 120, 101,  //
                                        72, 92, 95, 98, 112, 100, 103, 99};

Block table(int quality) {
  const int scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  Block steps;
  for (std::size_t i = 0; i < 64; ++i) {
    steps[i] = static_cast<float>(std::clamp((luminance[i] * scale + 50) / 100, 1, 255));
  }
  return steps;
}

// Row k holds the k-th cosine.
Block cosines() {
  Block c;
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t x = 0; x < 8; ++x) {
      const double norm = k == 0 ? std::sqrt(0.125) : 0.5;
      const double angle = static_cast<double>((2 * x + 1) * k) * pi / 16;
      c[8 * k + x] = static_cast<float>(norm * cosine(angle));
    }
  }
  return c;
}

Block transpose(const Block& a) {
  Block t;
  for (std::size_t i = 0; i < 64; ++i) t[i % 8 * 8 + i / 8] = a[i];
  return t;
}

Block product(const Block& a, const Block& b) {
  Block p{};
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < 8; ++k) {
      const float f = a[8 * i + k];
      for (std::size_t j = 0; j < 8; ++j) p[8 * i + j] += f * b[8 * k + j];
    }
  }
  return p;
}

float nearest(float x) { return static_cast<float>(static_cast<int>(x + (x < 0 ? -0.5F : 0.5F))); }

}  // namespace

void damage_as_jpeg(std::span<std::uint8_t> grey, int width, int height, int quality) {
  const Block forward = cosines();
  const Block backward = transpose(forward);
  const Block steps = table(std::clamp(quality, 1, 100));
  const auto at = [&](int x, int y) -> std::uint8_t& {
    return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  };
  for (int top = 0; top < height; top += 8) {
    for (int left = 0; left < width; left += 8) {
      Block block;
      for (int i = 0; i < 64; ++i) {
        const int x = std::min(left + i % 8, width - 1);
        const int y = std::min(top + i / 8, height - 1);
        block[static_cast<std::size_t>(i)] = static_cast<float>(at(x, y)) - 128;
      }
      block = product(product(forward, block), backward);
      for (std::size_t i = 0; i < 64; ++i) block[i] = steps[i] * nearest(block[i] / steps[i]);
      block = product(product(backward, block), forward);
      for (int i = 0; i < 64; ++i) {
        const int x = left + i % 8;
        const int y = top + i / 8;
        if (x >= width || y >= height) continue;
        at(x, y) =
            static_cast<std::uint8_t>(std::clamp(block[static_cast<std::size_t>(i)] + 128.5F, 0.0F, 255.0F));
      }
    }
  }
}

}  // namespace runmark::render
