#include "threshold/tiles.h"

#include <algorithm>
#include <cstring>

namespace runmark {
namespace {

/// Four bytes' worth of one level.
constexpr std::uint32_t four_times(std::uint8_t level) { return level * 0x01010101U; }

/// Eight bytes of 0 or 1 as eight bits, the first lowest.
constexpr std::uint64_t pack_eight(std::uint64_t bytes) { return (bytes * 0x0102040810204080U) >> 56; }
static_assert(pack_eight(0x0100000000000001) == 0x81 && pack_eight(0x0000000001000000) == 0x08);

std::uint8_t least(std::uint8_t a, std::uint8_t b) { return a < b ? a : b; }
std::uint8_t greatest(std::uint8_t a, std::uint8_t b) { return a > b ? a : b; }

/// The bits of up to 64 pixels: 1 where the level of the pixel's tile is not reached.
BitWord threshold_word(const std::uint8_t* grey, std::size_t pixels, const std::uint8_t* levels) {
  std::uint8_t level[bits_per_word];
  std::uint8_t dark[bits_per_word] = {};
  const std::size_t tiles = (pixels + tile_side - 1) / tile_side;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    const std::uint32_t four = four_times(levels[tile]);
    std::memcpy(level + tile * tile_side, &four, sizeof(four));
  }
  for (std::size_t x = 0; x < pixels; ++x) dark[x] = grey[x] < level[x] ? 1 : 0;
  BitWord bits = 0;
  for (std::size_t k = 0; k < bits_per_word / 8; ++k) {
    std::uint64_t eight = 0;
    for (std::size_t i = 0; i < 8; ++i) eight |= std::uint64_t{dark[8 * k + i]} << (8 * i);
    bits |= pack_eight(eight) << (8 * k);
  }
  return bits;
}

}  // namespace

void tile_extremes(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest) {
  // Down the columns first, many at a time, then across each tile.
  constexpr int stretch = 64;
  std::uint8_t low[stretch];
  std::uint8_t high[stretch];
  for (int begin = 0; begin < width; begin += stretch) {
    const int count = std::min(stretch, width - begin);
    const std::uint8_t* a = band[0] + begin;
    const std::uint8_t* b = band[1] + begin;
    const std::uint8_t* c = band[2] + begin;
    const std::uint8_t* d = band[3] + begin;
    for (int x = 0; x < count; ++x) {
      low[x] = least(least(a[x], b[x]), least(c[x], d[x]));
      high[x] = greatest(greatest(a[x], b[x]), greatest(c[x], d[x]));
    }
    // The last column stands in for those beyond the frame.
    for (int x = count; x % tile_side != 0; ++x) {
      low[x] = low[count - 1];
      high[x] = high[count - 1];
    }
    const int tiles = tiles_across(count);
    const int first = begin / tile_side;
    for (int tile = 0; tile < tiles; ++tile) {
      const std::uint8_t* l = low + tile * tile_side;
      const std::uint8_t* h = high + tile * tile_side;
      lowest[first + tile] = least(least(l[0], l[1]), least(l[2], l[3]));
      highest[first + tile] = greatest(greatest(h[0], h[1]), greatest(h[2], h[3]));
    }
  }
}

void spread_extremes(const std::uint8_t* lowest, const std::uint8_t* highest, int tiles,
                     std::uint8_t* spread_lowest, std::uint8_t* spread_highest) {
  const std::uint8_t* __restrict low = lowest;
  const std::uint8_t* __restrict high = highest;
  std::uint8_t* __restrict out_low = spread_lowest;
  std::uint8_t* __restrict out_high = spread_highest;
  const int last = tiles - 1;
  const int second = std::min(1, last);
  spread_lowest[0] = least(lowest[0], lowest[second]);
  spread_highest[0] = greatest(highest[0], highest[second]);
  for (int tile = 1; tile < last; ++tile) {
    out_low[tile] = least(least(low[tile - 1], low[tile]), low[tile + 1]);
    out_high[tile] = greatest(greatest(high[tile - 1], high[tile]), high[tile + 1]);
  }
  if (last > 0) {
    spread_lowest[last] = least(lowest[last - 1], lowest[last]);
    spread_highest[last] = greatest(highest[last - 1], highest[last]);
  }
}

void tile_levels(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                 std::uint8_t* levels) {
  // Restricted pointers and narrow integers let the compiler take many tiles at a time.
  const std::uint8_t* __restrict low0 = bands[0].lowest;
  const std::uint8_t* __restrict low1 = bands[1].lowest;
  const std::uint8_t* __restrict low2 = bands[2].lowest;
  const std::uint8_t* __restrict high0 = bands[0].highest;
  const std::uint8_t* __restrict high1 = bands[1].highest;
  const std::uint8_t* __restrict high2 = bands[2].highest;
  std::uint8_t* __restrict out = levels;
  const auto share = static_cast<std::uint16_t>(rule.share);
  const auto contrast = static_cast<std::uint16_t>(rule.contrast);
  for (int tile = 0; tile < tiles; ++tile) {
    const std::uint16_t low = least(least(low0[tile], low1[tile]), low2[tile]);
    const std::uint16_t high = greatest(greatest(high0[tile], high1[tile]), high2[tile]);
    const auto range = static_cast<std::uint16_t>(high - low);
    const auto level = static_cast<std::uint16_t>(low + static_cast<std::uint16_t>(range * share) / 16);
    out[tile] = static_cast<std::uint8_t>(range < contrast ? 0 : level);
  }
}

void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits) {
  constexpr std::size_t tiles_per_word = bits_per_word / tile_side;
  const std::size_t whole = static_cast<std::size_t>(width) / bits_per_word;
  for (std::size_t w = 0; w < whole; ++w) {
    bits[w] = threshold_word(grey + w * bits_per_word, bits_per_word, levels + w * tiles_per_word);
  }
  bits[whole] = threshold_word(grey + whole * bits_per_word, static_cast<std::size_t>(width) % bits_per_word,
                               levels + whole * tiles_per_word);
}

}  // namespace runmark
