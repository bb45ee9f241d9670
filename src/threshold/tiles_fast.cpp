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
void TileLightOf(const TileBand& band, int width, TileLight& light) {
  runmark::tile_light(band, width, light);
}
void TileLevelsOf(const ThreeBands& bands, int tiles, const TileRule& rule, std::uint8_t* levels) {
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

/// Joins the four bytes of each tile: afterwards the first is right.
template <class Join>
HWY_INLINE hn::Vec<TileBytes> AcrossTiles(hn::Vec<Bytes> v, Join&& join) {
  const Bytes d;
  const Words words;
  v = join(v, hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(words, v))));
  v = join(v, hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(words, v))));
  // Not TruncateTo: Highway 1.0.3 permutes words instead of bytes there with the newer AVX-512.
  return hn::U8FromU32(hn::And(hn::BitCast(words, v), hn::Set(words, 0xFF)));
}

void TileLightOf(const TileBand& band, int width, TileLight& light) {
  const Bytes d;
  const TileBytes tiles;
  const auto least = [](auto a, auto b) HWY_ATTR { return hn::Min(a, b); };
  const auto greatest = [](auto a, auto b) HWY_ATTR { return hn::Max(a, b); };
  const auto mean_of = [](auto a, auto b) HWY_ATTR { return hn::AverageRound(a, b); };
  const auto lanes = static_cast<int>(hn::Lanes(d));
  const int whole = width >= lanes ? width / tile_side * tile_side : 0;
  for (int next = 0; next < whole; next += lanes) {
    const int x = std::min(next, whole - lanes);  // the last vector overlaps with the one before
    const auto a = hn::LoadU(d, band[0] + x);
    const auto b = hn::LoadU(d, band[1] + x);
    const auto c = hn::LoadU(d, band[2] + x);
    const auto e = hn::LoadU(d, band[3] + x);
    const auto joined = [&](auto join) HWY_ATTR { return AcrossTiles(join(join(a, b), join(c, e)), join); };
    const int tile = x / tile_side;
    hn::StoreU(joined(least), tiles, light.lowest.data() + tile);
    hn::StoreU(joined(greatest), tiles, light.highest.data() + tile);
    hn::StoreU(joined(mean_of), tiles, light.mean.data() + tile);
  }
  if (whole == width) return;
  const TileBand rest{band[0] + whole, band[1] + whole, band[2] + whole, band[3] + whole};
  runmark::tile_light(rest, width - whole, light, static_cast<std::size_t>(whole / tile_side));
}

/// Bytes divided by 2^bits.
template <int bits, class D>
HWY_INLINE hn::Vec<D> Part(D d, hn::Vec<D> v) {
  const hn::Repartition<std::uint16_t, D> pairs;
  return hn::And(hn::BitCast(d, hn::ShiftRight<bits>(hn::BitCast(pairs, v))),
                 hn::Set(d, std::uint8_t{0xFF >> bits}));
}

/// The levels of the tiles from `tile` on, as many as a vector holds.
template <class D>
HWY_INLINE void LevelsAt(D d, const ThreeBands& bands, std::size_t tile, const TileRule& rule,
                         std::uint8_t* levels) {
  const hn::Repartition<std::uint16_t, D> pairs;
  const auto& [above, own, below] = bands;
  const auto share = hn::Set(pairs, static_cast<std::uint16_t>(rule.share));
  const auto load = [&](const std::vector<std::uint8_t>& row)
                        HWY_ATTR { return hn::LoadU(d, row.data() + tile); };
  const auto low = hn::Min(hn::Min(load(above->lowest), load(own->lowest)), load(below->lowest));
  const auto high = hn::Max(hn::Max(load(above->highest), load(own->highest)), load(below->highest));
  const auto mean = hn::AverageRound(hn::AverageRound(load(above->mean), load(below->mean)), load(own->mean));
  const auto range = hn::Sub(high, low);
  const auto even = hn::And(hn::BitCast(pairs, range), hn::Set(pairs, std::uint16_t{0xFF}));
  const auto odd = hn::ShiftRight<8>(hn::BitCast(pairs, range));
  const auto even_rise = hn::ShiftRight<4>(hn::Mul(even, share));
  const auto odd_rise = hn::ShiftLeft<8>(hn::ShiftRight<4>(hn::Mul(odd, share)));
  const auto rise = hn::BitCast(d, hn::Or(even_rise, odd_rise));
  const auto lack = hn::SaturatedSub(hn::Add(low, Part<1>(d, range)), mean);
  const auto fall =
      hn::Min(hn::Min(hn::Sub(lack, Part<2>(d, lack)), hn::Sub(Part<2>(d, range), Part<4>(d, range))), rise);
  const auto level = hn::Sub(hn::Add(low, rise), fall);
  const auto dim_contrast = hn::Set(d, static_cast<std::uint8_t>(rule.dim_contrast));
  const auto limit =
      hn::Min(hn::Max(low, dim_contrast), hn::Set(d, static_cast<std::uint8_t>(rule.contrast)));
  hn::StoreU(hn::IfThenZeroElse(hn::Lt(range, limit), level), d, levels + tile);
}

/// All tiles; the last vector overlaps with the one before. Nothing where a vector is too long.
template <class D>
HWY_INLINE bool LevelsOfAll(D d, const ThreeBands& bands, std::size_t tiles, const TileRule& rule,
                            std::uint8_t* levels) {
  const std::size_t lanes = hn::Lanes(d);
  if (tiles < lanes) return false;
  for (std::size_t t = 0; t + lanes < tiles; t += lanes) LevelsAt(d, bands, t, rule, levels);
  LevelsAt(d, bands, tiles - lanes, rule, levels);
  return true;
}

void TileLevelsOf(const ThreeBands& bands, int tiles, const TileRule& rule, std::uint8_t* levels) {
  const auto count = static_cast<std::size_t>(tiles);
  if (LevelsOfAll(Bytes(), bands, count, rule, levels)) return;
  if (LevelsOfAll(hn::CappedTag<std::uint8_t, 16>(), bands, count, rule, levels)) return;
  runmark::tile_levels(bands, tiles, rule, levels);
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

HWY_EXPORT(TileLightOf);
HWY_EXPORT(TileLevelsOf);
HWY_EXPORT(ThresholdRowOf);

void tile_light(const TileBand& band, int width, TileLight& light) {
  HWY_DYNAMIC_DISPATCH(TileLightOf)(band, width, light);
}

void tile_levels(const ThreeBands& bands, int tiles, const TileRule& rule, std::uint8_t* levels) {
  HWY_DYNAMIC_DISPATCH(TileLevelsOf)(bands, tiles, rule, levels);
}

void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits) {
  HWY_DYNAMIC_DISPATCH(ThresholdRowOf)(grey, width, levels, bits);
}

}  // namespace runmark::fast
#endif
