#include "threshold/grey_fast.h"

#include <cstddef>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "threshold/grey_fast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
void GreyRow(const std::uint8_t* pixels, int width, int step, PixelFormat format, std::uint8_t* grey) {
  runmark::grey_row(pixels, width, step, format, grey);
}
#else
namespace hn = hwy::HWY_NAMESPACE;
using Bytes = hn::ScalableTag<std::uint8_t>;
using Pairs = hn::Repartition<std::uint16_t, Bytes>;
using Vector = hn::Vec<Bytes>;
using PairVector = hn::Vec<Pairs>;

HWY_INLINE PairVector WeightedSum(PairVector red, PairVector green, PairVector blue) {
  const Pairs d;
  const auto weigh = [&](PairVector v, std::uint16_t weight)
                         HWY_ATTR { return hn::Mul(v, hn::Set(d, weight)); };
  const auto sum = hn::Add(hn::Add(weigh(red, 77), weigh(green, 150)), weigh(blue, 29));
  return hn::ShiftRight<8>(hn::Add(sum, hn::Set(d, std::uint16_t{128})));
}

HWY_INLINE Vector GreyOf(Vector red, Vector green, Vector blue) {
  const Bytes d;
  const Pairs pairs;
  const auto even = [&](Vector v) HWY_ATTR {
    return hn::And(hn::BitCast(pairs, v), hn::Set(pairs, std::uint16_t{0xFF}));
  };
  const auto odd = [&](Vector v) HWY_ATTR { return hn::ShiftRight<8>(hn::BitCast(pairs, v)); };
  const auto low = WeightedSum(even(red), even(green), even(blue));
  const auto high = WeightedSum(odd(red), odd(green), odd(blue));
  return hn::BitCast(d, hn::Or(low, hn::ShiftLeft<8>(high)));
}

void GreyRow(const std::uint8_t* pixels, int width, int step, PixelFormat format, std::uint8_t* grey) {
  const Bytes d;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  int x = 0;
  if (format == PixelFormat::grey && step == 1) {
    std::memcpy(grey, pixels, static_cast<std::size_t>(width));
    return;
  }
  if (format == PixelFormat::grey && step == 2) {
    // The last pixel may have no second byte.
    for (; x + lanes < width; x += lanes) {
      Vector luma;
      Vector other;
      hn::LoadInterleaved2(d, pixels + static_cast<std::ptrdiff_t>(x) * 2, luma, other);
      hn::StoreU(luma, d, grey + x);
    }
  }
  if (format != PixelFormat::grey && step == 3) {
    for (; x + lanes <= width; x += lanes) {
      Vector first;
      Vector second;
      Vector third;
      hn::LoadInterleaved3(d, pixels + static_cast<std::ptrdiff_t>(x) * 3, first, second, third);
      const bool rgb = format == PixelFormat::rgb;
      hn::StoreU(GreyOf(rgb ? first : third, second, rgb ? third : first), d, grey + x);
    }
  }
  runmark::grey_row(pixels + static_cast<std::ptrdiff_t>(x) * step, width - x, step, format, grey + x);
}

#endif

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark::fast {

HWY_EXPORT(GreyRow);

void grey_row(const std::uint8_t* pixels, int width, int step, PixelFormat format, std::uint8_t* grey) {
  HWY_DYNAMIC_DISPATCH(GreyRow)(pixels, width, step, format, grey);
}

}  // namespace runmark::fast
#endif
