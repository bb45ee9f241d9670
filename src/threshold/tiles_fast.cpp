#include "threshold/tiles_fast.h"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "threshold/tiles_fast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
void TileExtremesOf(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest) {
  runmark::tile_extremes(band, width, lowest, highest);
}
void TileLevelsOf(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                  std::uint8_t* levels) {
  runmark::tile_levels(bands, tiles, rule, levels);
}
void ThresholdRowOf(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits) {
  runmark::threshold_row(grey, width, levels, bits);
}
#else
namespace hn = hwy::HWY_NAMESPACE;
using Bytes = hn::CappedTag<std::uint8_t, bits_per_word>;  // a word of a bit row has 64 pixels
using Words = hn::Repartition<std::uint32_t, Bytes>;       // a tile's row each
using TileBytes = hn::Rebind<std::uint8_t, Words>;
using Pairs = hn::Repartition<std::uint16_t, Bytes>;

/// As many pixels of a row as whole vectors hold.
HWY_INLINE int whole_vectors(int width) {
  const auto lanes = static_cast<int>(hn::Lanes(Bytes()));
  return width / lanes * lanes;
}

void TileExtremesOf(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest) {
  const Bytes d;
  const Words words;
  const TileBytes tiles;
  const int whole = whole_vectors(width);
  for (int x = 0; x < whole; x += static_cast<int>(hn::Lanes(d))) {
    const auto a = hn::LoadU(d, band[0] + x);
    const auto b = hn::LoadU(d, band[1] + x);
    const auto c = hn::LoadU(d, band[2] + x);
    const auto e = hn::LoadU(d, band[3] + x);
    auto low = hn::Min(hn::Min(a, b), hn::Min(c, e));
    auto high = hn::Max(hn::Max(a, b), hn::Max(c, e));
    // Of four bytes the first is right afterwards; zeros come in above it only.
    low = hn::Min(low, hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(words, low))));
    high = hn::Max(high, hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(words, high))));
    low = hn::Min(low, hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(words, low))));
    high = hn::Max(high, hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(words, high))));
    hn::StoreU(hn::TruncateTo(tiles, hn::BitCast(words, low)), tiles, lowest + x / tile_side);
    hn::StoreU(hn::TruncateTo(tiles, hn::BitCast(words, high)), tiles, highest + x / tile_side);
  }
  if (whole == width) return;
  const TileBand rest{band[0] + whole, band[1] + whole, band[2] + whole, band[3] + whole};
  runmark::tile_extremes(rest, width - whole, lowest + whole / tile_side, highest + whole / tile_side);
}

void TileLevelsOf(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                  std::uint8_t* levels) {
  const Bytes d;
  const Pairs pairs;
  const auto contrast = hn::Set(d, static_cast<std::uint8_t>(rule.contrast));
  const auto share = hn::Set(pairs, static_cast<std::uint16_t>(rule.share));
  const auto low_byte = hn::Set(pairs, std::uint16_t{0xFF});
  const int whole = whole_vectors(tiles);
  for (int t = 0; t < whole; t += static_cast<int>(hn::Lanes(d))) {
    const auto low = hn::Min(hn::Min(hn::LoadU(d, bands[0].lowest + t), hn::LoadU(d, bands[1].lowest + t)),
                             hn::LoadU(d, bands[2].lowest + t));
    const auto high = hn::Max(hn::Max(hn::LoadU(d, bands[0].highest + t), hn::LoadU(d, bands[1].highest + t)),
                              hn::LoadU(d, bands[2].highest + t));
    const auto range = hn::Sub(high, low);
    const auto even = hn::And(hn::BitCast(pairs, range), low_byte);
    const auto odd = hn::ShiftRight<8>(hn::BitCast(pairs, range));
    const auto even_part = hn::ShiftRight<4>(hn::Mul(even, share));
    const auto odd_part = hn::ShiftLeft<8>(hn::ShiftRight<4>(hn::Mul(odd, share)));
    const auto level = hn::Add(low, hn::BitCast(d, hn::Or(even_part, odd_part)));
    hn::StoreU(hn::IfThenZeroElse(hn::Lt(range, contrast), level), d, levels + t);
  }
  std::array<TileExtremes, 3> rest = bands;
  for (TileExtremes& band : rest) band = {band.lowest + whole, band.highest + whole};
  runmark::tile_levels(rest, tiles - whole, rule, levels + whole);
}

void ThresholdRowOf(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits) {
  const Bytes d;
  const Words words;
  const TileBytes tiles;
  const auto first_of_four = hn::And(hn::Iota(d, 0), hn::Set(d, std::uint8_t{0x0C}));
  auto* bytes = reinterpret_cast<std::uint8_t*>(bits);
  const int whole = width / bits_per_word * bits_per_word;
  for (int x = 0; x < whole; x += static_cast<int>(hn::Lanes(d))) {
    const auto level = hn::PromoteTo(words, hn::LoadU(tiles, levels + x / tile_side));
    const auto dark =
        hn::Lt(hn::LoadU(d, grey + x), hn::TableLookupBytes(hn::BitCast(d, level), first_of_four));
    hn::StoreMaskBits(d, dark, bytes + x / 8);
  }
  // The last word takes what is left, sixteen pixels at a time while there are so many.
  const hn::CappedTag<std::uint8_t, 16> some;
  const hn::Repartition<std::uint32_t, decltype(some)> some_words;
  const hn::Rebind<std::uint8_t, decltype(some_words)> some_tiles;
  bits[whole / bits_per_word] = 0;
  int x = whole;
  for (; x + 16 <= width; x += static_cast<int>(hn::Lanes(some))) {
    const auto level = hn::PromoteTo(some_words, hn::LoadU(some_tiles, levels + x / tile_side));
    const auto four_times = hn::TableLookupBytes(
        hn::BitCast(some, level), hn::And(hn::Iota(some, 0), hn::Set(some, std::uint8_t{0xFC})));
    hn::StoreMaskBits(some, hn::Lt(hn::LoadU(some, grey + x), four_times), bytes + x / 8);
  }
  for (; x < width; ++x) {
    const BitWord dark = grey[x] < levels[x / tile_side] ? 1 : 0;
    bits[whole / bits_per_word] |= dark << (x - whole);
  }
}

#endif

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark::fast {

HWY_EXPORT(TileExtremesOf);
HWY_EXPORT(TileLevelsOf);
HWY_EXPORT(ThresholdRowOf);

void tile_extremes(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest) {
  HWY_DYNAMIC_DISPATCH(TileExtremesOf)(band, width, lowest, highest);
}

void tile_levels(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                 std::uint8_t* levels) {
  HWY_DYNAMIC_DISPATCH(TileLevelsOf)(bands, tiles, rule, levels);
}

void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits) {
  HWY_DYNAMIC_DISPATCH(ThresholdRowOf)(grey, width, levels, bits);
}

}  // namespace runmark::fast
#endif
