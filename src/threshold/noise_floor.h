#pragma once

#include <array>
#include <cstdint>

#include "threshold/tiles.h"

namespace runmark {

/// Follows the sensor noise of a frame: the lower quartile of the contrasts that the threshold has seen so
/// far, each the range of grey levels over 3x3 tiles. Flat parts of a picture are what noise alone fills, so
/// contrasts not much above the quartile may be noise. Only rows already seen count, so that streaming and
/// whole frames agree.
class NoiseFloor {
 public:
  void begin_frame() {
    counts_.fill(0);
    seen_ = 0;
  }

  /// Takes every `tile_stride`-th tile of a band between its neighbours: noise does not change from tile to
  /// tile.
  void add(const ThreeBands& bands, int tiles);

  /// The contrast that the noise asks for now; nothing while too little was seen.
  [[nodiscard]] int contrast() const;

 private:
  static constexpr int tile_stride = 8;
  std::array<std::uint32_t, 256> counts_{};
  std::uint32_t seen_ = 0;
};

}  // namespace runmark
