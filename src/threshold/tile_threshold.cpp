#include "threshold/tile_threshold.h"

#include <algorithm>

#include "threshold/tiles_fast.h"

namespace runmark {

TileThreshold::TileThreshold(int max_width) {
  const auto tiles = static_cast<std::size_t>(tiles_across(max_width));
  for (Extremes* extremes : {&fresh_, &spread_[0], &spread_[1], &spread_[2]}) {
    extremes->lowest.resize(tiles);
    extremes->highest.resize(tiles);
  }
  levels_.resize(tiles);
}

void TileThreshold::begin_frame(int width, const TileRule& rule) {
  width_ = width;
  tiles_ = tiles_across(width);
  rule_ = rule;
  bands_ = 0;
  noise_.begin_frame();
}

void TileThreshold::add_band(const TileBand& band) {
  fast::tile_extremes(band, width_, fresh_.lowest.data(), fresh_.highest.data());
  std::swap(spread_[0], spread_[1]);
  std::swap(spread_[1], spread_[2]);
  spread_extremes(fresh_.lowest.data(), fresh_.highest.data(), tiles_, spread_[2].lowest.data(),
                  spread_[2].highest.data());
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
  const auto view = [](const Extremes& e) { return TileExtremes{e.lowest.data(), e.highest.data()}; };
  const Extremes& above = bands_ > 2 ? spread_[0] : spread_[1];
  const std::array bands{view(above), view(spread_[1]), view(spread_[2])};
  noise_.add(bands, tiles_);
  const TileRule rule{noise_.contrast_limit(rule_.contrast), rule_.share};
  fast::tile_levels(bands, tiles_, rule, levels_.data());
}

std::size_t TileThreshold::memory() const { return sizeof(*this) + levels_.size() * 9; }

}  // namespace runmark
