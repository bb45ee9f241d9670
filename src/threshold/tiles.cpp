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

void tile_light(const TileBand& band, int width, TileLight& light, std::size_t first) {
  // Down the columns first, many at a time, then across each tile.
  constexpr int stretch = 64;
  std::uint8_t low[stretch];
  std::uint8_t high[stretch];
  std::uint8_t mean[stretch];
  for (int begin = 0; begin < width; begin += stretch) {
    const int count = std::min(stretch, width - begin);
    const std::uint8_t* a = band[0] + begin;
    const std::uint8_t* b = band[1] + begin;
    const std::uint8_t* c = band[2] + begin;
    const std::uint8_t* d = band[3] + begin;
    for (int x = 0; x < count; ++x) {
      low[x] = least(least(a[x], b[x]), least(c[x], d[x]));
      high[x] = greatest(greatest(a[x], b[x]), greatest(c[x], d[x]));
      mean[x] = mean_of(mean_of(a[x], b[x]), mean_of(c[x], d[x]));
    }
    // The last column stands in for those beyond the frame.
    for (int x = count; x % tile_side != 0; ++x) {
      low[x] = low[count - 1];
      high[x] = high[count - 1];
      mean[x] = mean[count - 1];
    }
    const int tiles = tiles_across(count);
    for (int tile = 0; tile < tiles; ++tile) {
      const std::uint8_t* l = low + tile * tile_side;
      const std::uint8_t* h = high + tile * tile_side;
      const std::uint8_t* m = mean + tile * tile_side;
      const std::size_t at = first + static_cast<std::size_t>(begin / tile_side + tile);
      light.lowest[at] = least(least(l[0], l[1]), least(l[2], l[3]));
      light.highest[at] = greatest(greatest(h[0], h[1]), greatest(h[2], h[3]));
      light.mean[at] = mean_of(mean_of(m[0], m[1]), mean_of(m[2], m[3]));
    }
  }
}

void spread_light(const TileLight& light, int tiles, TileLight& spread) {
  const std::uint8_t* __restrict low = light.lowest.data();
  const std::uint8_t* __restrict high = light.highest.data();
  const std::uint8_t* __restrict mean = light.mean.data();
  std::uint8_t* __restrict out_low = spread.lowest.data();
  std::uint8_t* __restrict out_high = spread.highest.data();
  std::uint8_t* __restrict out_mean = spread.mean.data();
  const int last = tiles - 1;
  // One loop each: the compiler takes many tiles at a time.
  for (int tile = 1; tile < last; ++tile)
    out_low[tile] = least(least(low[tile - 1], low[tile]), low[tile + 1]);
  for (int tile = 1; tile < last; ++tile) {
    out_high[tile] = greatest(greatest(high[tile - 1], high[tile]), high[tile + 1]);
  }
  for (int tile = 1; tile < last; ++tile) {
    out_mean[tile] = mean_of(mean_of(mean[tile - 1], mean[tile + 1]), mean[tile]);
  }
  for (const int tile : {0, last}) {
    const int other = tile == 0 ? std::min(1, last) : last - 1;
    if (other < 0) continue;
    out_low[tile] = least(low[tile], low[other]);
    out_high[tile] = greatest(high[tile], high[other]);
    out_mean[tile] = mean_of(mean_of(mean[tile], mean[other]), mean[tile]);
  }
}

void tile_levels(const ThreeBands& bands, int tiles, const TileRule& rule, std::uint8_t* levels) {
  const auto& [above, own, below] = bands;
  for (std::size_t tile = 0; tile < static_cast<std::size_t>(tiles); ++tile) {
    const int low = least(least(above->lowest[tile], own->lowest[tile]), below->lowest[tile]);
    const int high = greatest(greatest(above->highest[tile], own->highest[tile]), below->highest[tile]);
    const int mean = mean_of(mean_of(above->mean[tile], below->mean[tile]), own->mean[tile]);
    const int range = high - low;
    const int rise = range * rule.share / 16;
    const int lack = std::max(low + range / 2 - mean, 0);
    const int fall = std::min({lack - lack / 4, range / 4 - range / 16, rise});
    const int limit = std::min(std::max(low, rule.dim_contrast), rule.contrast);
    levels[tile] = static_cast<std::uint8_t>(range < limit ? 0 : low + rise - fall);
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
