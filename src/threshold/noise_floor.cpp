#include "threshold/noise_floor.h"

#include <algorithm>

namespace runmark {

void NoiseFloor::add(const ThreeBands& bands, int tiles) {
  const auto& [a, b, c] = bands;
  for (std::size_t tile = tile_stride / 2; tile < static_cast<std::size_t>(tiles); tile += tile_stride) {
    const int low = std::min({a->lowest[tile], b->lowest[tile], c->lowest[tile]});
    const int high = std::max({a->highest[tile], b->highest[tile], c->highest[tile]});
    ++counts_[static_cast<std::size_t>(high - low)];
    ++seen_;
  }
}

int NoiseFloor::contrast() const {
  constexpr std::uint32_t least_sample = 64;
  if (seen_ < least_sample) return 0;
  std::uint32_t below = 0;
  int quartile = 0;
  while (below + counts_[static_cast<std::size_t>(quartile)] <= seen_ / 4) {
    below += counts_[static_cast<std::size_t>(quartile)];
    ++quartile;
  }
  // Three quarters more than flat parts show: what is only noise seldom has it.
  return quartile * 7 / 4;
}

}  // namespace runmark
