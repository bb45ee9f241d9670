#include "threshold/tiles.h"

#include <algorithm>

namespace runmark {

void tile_extremes(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest) {
  for (int tile = 0; tile < tiles_across(width); ++tile) {
    const int begin = tile * tile_side;
    const int end = std::min(begin + tile_side, width);
    std::uint8_t low = 255;
    std::uint8_t high = 0;
    for (const std::uint8_t* row : band) {
      for (int x = begin; x < end; ++x) {
        low = std::min(low, row[x]);
        high = std::max(high, row[x]);
      }
    }
    lowest[tile] = low;
    highest[tile] = high;
  }
}

void spread_extremes(const std::uint8_t* lowest, const std::uint8_t* highest, int tiles,
                     std::uint8_t* spread_lowest, std::uint8_t* spread_highest) {
  for (int tile = 0; tile < tiles; ++tile) {
    const int left = std::max(tile - 1, 0);
    const int right = std::min(tile + 1, tiles - 1);
    spread_lowest[tile] = std::min({lowest[left], lowest[tile], lowest[right]});
    spread_highest[tile] = std::max({highest[left], highest[tile], highest[right]});
  }
}

void tile_levels(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                 std::uint8_t* levels) {
  for (int tile = 0; tile < tiles; ++tile) {
    const int low = std::min({bands[0].lowest[tile], bands[1].lowest[tile], bands[2].lowest[tile]});
    const int high = std::max({bands[0].highest[tile], bands[1].highest[tile], bands[2].highest[tile]});
    const int level = low + (high - low) * rule.share / 16;
    levels[tile] = static_cast<std::uint8_t>(high - low < rule.contrast ? 0 : level);
  }
}

void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits) {
  std::fill_n(bits, bit_words(width), BitWord{0});
  for (int x = 0; x < width; ++x) {
    const bool dark = grey[x] < levels[x / tile_side];
    bits[x / bits_per_word] |= BitWord{dark} << (x % bits_per_word);
  }
}

}  // namespace runmark
