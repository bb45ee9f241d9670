#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace runmark::render {

/// Scrambles 64 bits so that neighbouring inputs give unrelated outputs. Source: the finalizer of
/// SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// FNV-1a of a name, for seeds.
[[nodiscard]] constexpr std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325U;
  for (const char c : text) h = (h ^ static_cast<std::uint8_t>(c)) * 0x100000001b3U;
  return h;
}

/// Random numbers that are the same on every machine, which the distributions of <random> are not.
class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] constexpr std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15U); }

  /// In [0, 1).
  [[nodiscard]] constexpr double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  [[nodiscard]] constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In [0, n); n at least 1. The bias for small n is below 2^-50.
  [[nodiscard]] constexpr int below(int n) { return static_cast<int>(uniform() * n); }

  [[nodiscard]] constexpr bool chance(double p) { return uniform() < p; }

  /// About normal, mean 0 and deviation 1, within 4.9: the sum of eight random bytes of one draw.
  [[nodiscard]] constexpr float normal() {
    const std::uint64_t r = next();
    constexpr std::uint64_t even = 0x00ff00ff00ff00ffU;
    const std::uint64_t pairs = (r & even) + ((r >> 8U) & even);
    const auto sum = static_cast<int>((pairs * 0x0001000100010001U) >> 48U);
    constexpr float deviation = 209.021530F;  // sqrt(8 * (256 * 256 - 1) / 12)
    return static_cast<float>(sum - 1020) / deviation;
  }

 private:
  std::uint64_t state_;
};

}  // namespace runmark::render
