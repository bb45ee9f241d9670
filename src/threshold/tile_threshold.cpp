#include "threshold/tile_threshold.h"

#include <algorithm>

#include "threshold/tiles_fast.h"

namespace runmark {

TileThreshold::TileThreshold(int max_width)
    : fresh_(static_cast<std::size_t>(tiles_across(max_width))),
      spread_{fresh_, fresh_, fresh_},
      levels_(fresh_.mean.size()) {}

void TileThreshold::begin_frame(int width, const TileRule& rule) {
  width_ = width;
  tiles_ = tiles_across(width);
  rule_ = rule;
  bands_ = 0;
  noise_.begin_frame();
}

void TileThreshold::add_band(const TileBand& band) {
  fast::tile_light(band, width_, fresh_);
  std::swap(spread_[0], spread_[1]);
  std::swap(spread_[1], spread_[2]);
  spread_light(fresh_, tiles_, spread_[2]);
  ++bands_;
  find_levels();
}

void TileThreshold::finish() {
  std::swap(spread_[0], spread_[1]);
  std::swap(spread_[1], spread_[2]);
  spread_[2] = spread_[1];
  ++bands_;
  find_levels();
}

void TileThreshold::find_levels() {
  if (bands_ < 2) return;
  // Above the first band there is nothing, so the band itself stands in.
  const ThreeBands bands{bands_ > 2 ? &spread_[0] : &spread_[1], &spread_[1], &spread_[2]};
  noise_.add(bands, tiles_);
  constexpr int highest_limit = 40;  // keeps dim markers on textured walls
  const int noise = std::min(noise_.contrast(), highest_limit);
  const TileRule rule{std::max(rule_.contrast, noise), rule_.share, std::max(rule_.dim_contrast, noise)};
  fast::tile_levels(bands, tiles_, rule, levels_.data());
}

std::size_t TileThreshold::memory() const { return sizeof(*this) + levels_.size() * 13; }

}  // namespace runmark
