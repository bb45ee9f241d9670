#include "threshold/noise_floor.h"

#include <algorithm>

namespace runmark {

void NoiseFloor::add(const std::uint8_t* lowest, const std::uint8_t* highest, int tiles) {
  for (int tile = tile_stride / 2; tile < tiles; tile += tile_stride) {
    ++counts_[static_cast<std::size_t>(highest[tile] - lowest[tile])];
    ++seen_;
  }
}

int NoiseFloor::contrast_limit(int minimum) const {
  constexpr std::uint32_t least_sample = 64;
  constexpr int highest_limit = 40;
  if (seen_ < least_sample) return minimum;
  std::uint32_t below = 0;
  int quartile = 0;
  while (below + counts_[static_cast<std::size_t>(quartile)] <= seen_ / 4) {
    below += counts_[static_cast<std::size_t>(quartile)];
    ++quartile;
  }
  // The range of 144 noise values (nine tiles) is 1.5 times that of 16 on average; 2.2 leaves room.
  return std::clamp(quartile * 11 / 5, minimum, std::max(minimum, highest_limit));
}

}  // namespace runmark
