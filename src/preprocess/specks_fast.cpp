#include "preprocess/specks_fast.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "preprocess/specks_fast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A word of three rows each, and the words before and after it.
using Words = std::array<const BitWord*, 3>;

/// The pixels of the words of the middle row that `rows` point to, without their specks.
template <class D>
HWY_INLINE hn::Vec<D> Clean(D d, const Words& before, const Words& rows, const Words& after, bool eight) {
  const auto load = [&](const BitWord* words) HWY_ATTR { return hn::LoadU(d, words); };
  const auto west = [&](std::size_t row) HWY_ATTR {
    return hn::Or(hn::ShiftLeft<1>(load(rows[row])), hn::ShiftRight<bits_per_word - 1>(load(before[row])));
  };
  const auto east = [&](std::size_t row) HWY_ATTR {
    return hn::Or(hn::ShiftRight<1>(load(rows[row])), hn::ShiftLeft<bits_per_word - 1>(load(after[row])));
  };
  const auto own = load(rows[1]);
  const auto n = load(rows[0]);
  const auto s = load(rows[2]);
  const auto w = west(1);
  const auto e = east(1);
  auto dark = hn::AndNot(hn::Or(hn::Or(n, s), hn::Or(w, e)), own);
  auto light = hn::AndNot(own, hn::And(hn::And(n, s), hn::And(w, e)));
  const auto with_diagonals = eight ? dark : light;
  if (!hn::AllTrue(d, hn::Eq(with_diagonals, hn::Zero(d)))) {
    if (eight) {
      dark = hn::AndNot(hn::Or(hn::Or(west(0), east(0)), hn::Or(west(2), east(2))), dark);
    } else {
      light = hn::And(hn::And(hn::And(west(0), east(0)), hn::And(west(2), east(2))), light);
    }
  }
  return hn::Xor(own, hn::Or(dark, light));
}

void DropSpecks(const BitWord* above, const BitWord* current, const BitWord* below, int width, bool eight,
                BitWord* out) {
  const auto at = [&](std::size_t i) { return Words{above + i, current + i, below + i}; };
  const std::size_t last = bit_words(width) - 1;
  const BitWord zero = 0;
  const Words none{&zero, &zero, &zero};
  // The first and the last word have no word beside them.
  const hn::CappedTag<BitWord, 1> one;
  for (const std::size_t i : {std::size_t{0}, last}) {
    hn::StoreU(Clean(one, i > 0 ? at(i - 1) : none, at(i), i < last ? at(i + 1) : none, eight), one, out + i);
  }
  const hn::CappedTag<BitWord, 8> d;
  const std::size_t lanes = hn::Lanes(d);
  if (last > lanes) {
    for (std::size_t next = 1; next < last; next += lanes) {
      const std::size_t i = std::min(next, last - lanes);  // the last vector overlaps with the one before
      hn::StoreU(Clean(d, at(i - 1), at(i), at(i + 1), eight), d, out + i);
    }
  } else {
    for (std::size_t i = 1; i < last; ++i) {
      hn::StoreU(Clean(one, at(i - 1), at(i), at(i + 1), eight), one, out + i);
    }
  }
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark::fast {

HWY_EXPORT(DropSpecks);

void drop_specks(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                 Connectivity connectivity, BitWord* out) {
  HWY_DYNAMIC_DISPATCH(DropSpecks)(above, current, below, width, connectivity == Connectivity::eight, out);
}

}  // namespace runmark::fast
#endif
