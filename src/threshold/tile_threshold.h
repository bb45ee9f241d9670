#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "threshold/noise_floor.h"
#include "threshold/tiles.h"

namespace runmark {

/// The light-following threshold of one stream of rows: holds the extremes of three bands of tiles, and
/// knows the levels of a band as soon as the band below it is in.
class TileThreshold {
 public:
  /// Sets memory aside for rows of up to `max_width` pixels.
  explicit TileThreshold(int max_width);

  /// The rule's contrasts are the least; they rise with the noise of the rows already seen.
  void begin_frame(int width, const TileRule& rule);

  /// Takes the next band. Afterwards `levels` are those of the band before it.
  void add_band(const TileBand& band);
  /// There is no further band: afterwards `levels` are those of the last one.
  void finish();

  [[nodiscard]] const std::uint8_t* levels() const { return levels_.data(); }
  [[nodiscard]] std::size_t memory() const;

 private:
  void find_levels();

  int tiles_ = 0;
  int width_ = 0;
  TileRule rule_;
  int bands_ = 0;
  NoiseFloor noise_;
  TileLight fresh_;                  // of the band just taken, not spread
  std::array<TileLight, 3> spread_;  // oldest first: above, the levels' own, below
  std::vector<std::uint8_t> levels_;
};

}  // namespace runmark
