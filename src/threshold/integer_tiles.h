#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "preprocess/bit_row.h"

namespace runmark {

/// Follows the sensor noise with one adder: an estimate of the lower quartile of the grey ranges of the
/// tiles, moved a little up by every tile above it and three times as far down by every other one. Flat
/// parts of a picture are what noise alone fills (see noise_floor.h). Integers only.
class RangeQuartile {
 public:
  void begin_frame() { sixty_fourths_ = 0; }
  void add(int range) {
    if (range * 64 > sixty_fourths_) {
      sixty_fourths_ += 1;
    } else if (sixty_fourths_ >= 3) {
      sixty_fourths_ -= 3;
    }
  }
  /// The contrast limit to use now: 2.25 times the quartile, at least `minimum` and, where that is less, at
  /// most 40.
  [[nodiscard]] int contrast_limit(int minimum) const {
    constexpr int highest = 40;
    const int limit = (9 * sixty_fourths_) >> 8;
    return limit < minimum ? minimum : limit < highest ? limit : minimum < highest ? highest : minimum;
  }

 private:
  int sixty_fourths_ = 0;
};

/// The light-following threshold of `--pipeline hardware`, a row at a time and in integers only; the
/// definition of the tile threshold in hardware. It has no part in common with the default pipeline's.
///
/// Least and greatest grey level of tiles of 4x4 pixels (cut short at the right and lower edge), spread over
/// the 3x3 neighbouring tiles; a pixel is dark below 9/16 of the way from the least to the greatest, and
/// light where they differ by less than the contrast limit. That limit follows the ranges of all tiles down
/// to the band below.
class IntegerTiles {
 public:
  static constexpr int side = 4;

  explicit IntegerTiles(int max_width);

  void begin_frame(int width, int height, int min_contrast);

  /// Takes the next row. True when it completes a band of tiles, or the frame: then the rows
  /// `ready_from` to `ready_to` can be thresholded.
  bool add_row(const std::uint8_t* grey);

  /// Rows [ready_from, ready_to) are those of the band above the one completed last.
  [[nodiscard]] int ready_from() const { return ready_from_; }
  [[nodiscard]] int ready_to() const { return ready_to_; }
  /// After the frame's last row: makes the last band's rows ready.
  void finish();

  /// Turns one of the ready rows into bits.
  void threshold(const std::uint8_t* grey, BitWord* bits) const;

  [[nodiscard]] std::size_t memory() const { return sizeof(*this) + 9 * levels_.size(); }

 private:
  struct Extremes {
    std::vector<std::uint8_t> lowest;
    std::vector<std::uint8_t> highest;
  };
  void find_levels(std::size_t below);

  int width_ = 0;
  int height_ = 0;
  int min_contrast_ = 20;
  int rows_ = 0;
  int ready_from_ = 0;
  int ready_to_ = 0;
  RangeQuartile noise_;
  std::array<Extremes, 3> bands_;  // above, the levels' own, the one being filled
  std::vector<std::uint8_t> levels_;
};

}  // namespace runmark
