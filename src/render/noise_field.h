#pragma once

#include <cstdint>

#include "render/rng.h"

namespace runmark::render {

/// The floor of a number that an int can hold; in line, which std::floor is not on every machine.
[[nodiscard]] inline int floor_int(double x) {
  const int i = static_cast<int>(x);
  return i - (x < i ? 1 : 0);
}

/// A random number in [0, 1) for each point of a grid.
[[nodiscard]] inline float lattice_value(int x, int y, std::uint32_t seed) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x8da6b343U ^ static_cast<std::uint32_t>(y) * 0xd8163841U ^ seed;
  h = (h ^ (h >> 15U)) * 0x2c1b3c6dU;
  h = (h ^ (h >> 12U)) * 0x297a2d39U;
  h ^= h >> 15U;
  return static_cast<float>(h >> 8U) * 0x1p-24F;
}

/// Smooth noise in [0, 1) with features about one unit wide.
[[nodiscard]] inline float smooth_noise(double x, double y, std::uint32_t seed) {
  const int ix = floor_int(x);
  const int iy = floor_int(y);
  const auto ease = [](float t) { return t * t * (3 - 2 * t); };
  const float tx = ease(static_cast<float>(x - ix));
  const float ty = ease(static_cast<float>(y - iy));
  const auto between = [](float a, float b, float t) { return a + (b - a) * t; };
  return between(between(lattice_value(ix, iy, seed), lattice_value(ix + 1, iy, seed), tx),
                 between(lattice_value(ix, iy + 1, seed), lattice_value(ix + 1, iy + 1, seed), tx), ty);
}

/// Smooth noise of several scales, each half as wide and half as strong as the one before; in [0, 1).
[[nodiscard]] inline float fractal_noise(double x, double y, int octaves, std::uint32_t seed) {
  float sum = 0;
  float weight = 0.5F;
  float total = 0;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * smooth_noise(x, y, seed + static_cast<std::uint32_t>(i) * 0x9e3779b9U);
    total += weight;
    weight *= 0.5F;
    x *= 2;
    y *= 2;
  }
  return sum / total;
}

}  // namespace runmark::render
