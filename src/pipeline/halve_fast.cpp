#include "pipeline/halve_fast.h"

#include <algorithm>

#include "pipeline/halve.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/halve_fast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
void HalveRows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half) {
  runmark::halve_rows(upper, lower, width, half);
}
#else
namespace hn = hwy::HWY_NAMESPACE;

void HalveRows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half) {
  const hn::ScalableTag<std::uint8_t> d;
  const hn::Repartition<std::uint16_t, decltype(d)> pairs;
  const hn::Rebind<std::uint8_t, decltype(pairs)> halves;
  const auto low_byte = hn::Set(pairs, std::uint16_t{0xFF});
  const auto lanes = static_cast<int>(hn::Lanes(halves));
  const auto sum_of_pairs = [&](const std::uint8_t* bytes) HWY_ATTR {
    const auto v = hn::BitCast(pairs, hn::LoadU(d, bytes));
    return hn::Add(hn::And(v, low_byte), hn::ShiftRight<8>(v));
  };
  if (width < lanes) return runmark::halve_rows(upper, lower, width, half);
  for (int next = 0; next < width; next += lanes) {
    const int x = std::min(next, width - lanes);  // the last vector overlaps with the one before
    const auto sum = hn::Add(sum_of_pairs(upper + 2 * x), sum_of_pairs(lower + 2 * x));
    const auto rounded = hn::ShiftRight<2>(hn::Add(sum, hn::Set(pairs, std::uint16_t{2})));
    hn::StoreU(hn::TruncateTo(halves, rounded), halves, half + x);
  }
}

#endif

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark::fast {

HWY_EXPORT(HalveRows);

void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half) {
  HWY_DYNAMIC_DISPATCH(HalveRows)(upper, lower, width, half);
}

}  // namespace runmark::fast
#endif
