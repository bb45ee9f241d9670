#include "threshold/integer_tiles.h"

#include <algorithm>
#include <utility>

namespace runmark {
namespace {

constexpr std::size_t tiles_of(int width) {
  return static_cast<std::size_t>((width + IntegerTiles::side - 1) / IntegerTiles::side);
}

}  // namespace

IntegerTiles::IntegerTiles(int max_width) : levels_(tiles_of(max_width)) {
  for (Extremes& band : bands_) {
    band.lowest.resize(levels_.size());
    band.highest.resize(levels_.size());
  }
}

void IntegerTiles::begin_frame(int width, int height, int min_contrast) {
  width_ = width;
  height_ = height;
  min_contrast_ = min_contrast;
  rows_ = 0;
  ready_from_ = 0;
  ready_to_ = 0;
  noise_.begin_frame();
}

bool IntegerTiles::add_row(const std::uint8_t* grey) {
  Extremes& band = bands_[2];
  const std::size_t tiles = tiles_of(width_);
  if (rows_ % side == 0) {
    std::fill_n(band.lowest.begin(), tiles, std::uint8_t{255});
    std::fill_n(band.highest.begin(), tiles, std::uint8_t{0});
  }
  for (int x = 0; x < width_; ++x) {
    const auto tile = static_cast<std::size_t>(x / side);
    band.lowest[tile] = std::min(band.lowest[tile], grey[x]);
    band.highest[tile] = std::max(band.highest[tile], grey[x]);
  }
  ++rows_;
  if (rows_ % side != 0 && rows_ < height_) return false;
  for (std::size_t tile = 0; tile < tiles; ++tile) noise_.add(band.highest[tile] - band.lowest[tile]);
  find_levels(2);
  std::swap(bands_[0], bands_[1]);
  std::swap(bands_[1], bands_[2]);
  return true;
}

void IntegerTiles::finish() { find_levels(1); }

/// The levels of the middle band; where there is no band below, or above, it stands in itself.
void IntegerTiles::find_levels(std::size_t below) {
  ready_from_ = ready_to_;
  const int band_ends = below == 1 ? height_ : (rows_ - 1) / side * side;
  ready_to_ = band_ends;
  if (ready_to_ == ready_from_) return;  // the first band: nothing above it
  const std::size_t above = ready_from_ == 0 ? 1 : 0;
  const int contrast = noise_.contrast_limit(min_contrast_);
  const std::size_t tiles = tiles_of(width_);
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    const std::size_t first = tile == 0 ? 0 : tile - 1;
    const std::size_t last = std::min(tile + 1, tiles - 1);
    int lowest = 255;
    int highest = 0;
    for (const std::size_t band : {above, std::size_t{1}, below}) {
      for (std::size_t t = first; t <= last; ++t) {
        lowest = std::min<int>(lowest, bands_[band].lowest[t]);
        highest = std::max<int>(highest, bands_[band].highest[t]);
      }
    }
    const int range = highest - lowest;
    levels_[tile] = static_cast<std::uint8_t>(range < contrast ? 0 : lowest + (range >> 1));
  }
}

void IntegerTiles::threshold(const std::uint8_t* grey, BitWord* bits) const {
  std::fill_n(bits, bit_words(width_), BitWord{0});
  for (int x = 0; x < width_; ++x) {
    if (grey[x] < levels_[static_cast<std::size_t>(x / side)]) set_bit(bits, x, true);
  }
}

}  // namespace runmark
