#pragma once

#include <array>
#include <cstdint>

namespace runmark {

/// Follows the sensor noise of a frame: the lower quartile of the grey ranges of the tiles seen so far.
/// Flat parts of a picture are what noise alone fills, so the quartile is about the range of sixteen
/// noise values, and contrasts of a few times it may be noise. Only rows already seen count, so that
/// streaming and whole frames agree.
class NoiseFloor {
 public:
  void begin_frame() {
    counts_.fill(0);
    seen_ = 0;
  }

  /// Takes every `tile_stride`-th tile of a band: noise does not change from tile to tile.
  void add(const std::uint8_t* lowest, const std::uint8_t* highest, int tiles);

  /// The contrast limit to use now: at least `minimum`, and what the noise asks for, up to a cap that
  /// keeps dim markers on textured walls.
  [[nodiscard]] int contrast_limit(int minimum) const;

 private:
  static constexpr int tile_stride = 8;
  std::array<std::uint32_t, 256> counts_{};
  std::uint32_t seen_ = 0;
};

}  // namespace runmark
