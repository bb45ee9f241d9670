#include "preprocess/crack_runs_fast.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "preprocess/crack_runs_fast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "preprocess/run_writer-inl.h"

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The events of as many words as a vector holds. A run's end belongs to the row above or to the current one,
/// as the pixel beyond it tells. There the two rows agree, except where runs touch crosswise: then it matters
/// at which row a top run looks and at which a bottom run, and that is the connectivity.
/// @param at  where the first of them goes
/// @return a bit for each word that has any
template <class D, class V = hn::Vec<D>>
HWY_INLINE BitWord FindEvents(D d, V above, V current, V above_left, V current_left, bool eight,
                              CrackEvents& events, std::size_t at) {
  // Columns beside the word's own: the last one of the word before.
  const auto shifted = [](V word, V word_left) HWY_ATTR {
    return hn::Or(hn::ShiftLeft<1>(word), hn::ShiftRight<bits_per_word - 1>(word_left));
  };
  const V left_of_above = shifted(above, above_left);
  const V left_of_current = shifted(current, current_left);
  const V top = hn::AndNot(above, current);
  const V bottom = hn::AndNot(current, above);
  const V left_top = hn::AndNot(left_of_above, left_of_current);
  const V left_bottom = hn::AndNot(left_of_current, left_of_above);
  const V begins = hn::Or(hn::AndNot(left_top, top), hn::AndNot(left_bottom, bottom));
  const V ends = hn::Or(hn::AndNot(top, left_top), hn::AndNot(bottom, left_bottom));
  std::uint8_t active[8] = {};
  hn::StoreMaskBits(d, hn::Ne(hn::Or(begins, ends), hn::Zero(d)), active);
  const V top_sees = eight ? above : current;
  const V bottom_sees = eight ? current : above;
  const V left_top_sees = eight ? left_of_above : left_of_current;
  const V left_bottom_sees = eight ? left_of_current : left_of_above;
  hn::StoreU(begins, d, events.begins + at);
  hn::StoreU(ends, d, events.ends + at);
  hn::StoreU(top, d, events.top + at);
  hn::StoreU(hn::Or(hn::And(top, left_top_sees), hn::AndNot(left_bottom_sees, bottom)), d,
             events.left_above + at);
  hn::StoreU(hn::Or(hn::And(left_top, top_sees), hn::AndNot(bottom_sees, left_bottom)), d,
             events.right_above + at);
  return active[0];
}

std::size_t FindCrackRuns(const BitWord* above, const BitWord* current, int width, bool eight,
                          CrackRun* runs) {
  const hn::CappedTag<BitWord, 8> d;
  const hn::CappedTag<BitWord, 4> half;
  const hn::CappedTag<BitWord, 1> one;
  const std::size_t words = bit_words(width);
  RunWriter writer(runs);
  CrackEvents events;  // NOLINT(*-member-init): FindEvents fills it
  for (std::size_t from = 0; from < words; from += CrackEvents::most_words) {
    const std::size_t to = std::min(from + CrackEvents::most_words, words);
    BitWord active = 0;
    std::size_t w = from;
    const auto find = [&](auto tag, auto above_left, auto current_left) HWY_ATTR {
      active |= FindEvents(tag, hn::LoadU(tag, above + w), hn::LoadU(tag, current + w), above_left,
                           current_left, eight, events, w - from)
                << (w - from);
      w += hn::Lanes(tag);
    };
    const auto find_next = [&](auto tag) HWY_ATTR {
      find(tag, hn::LoadU(tag, above + w - 1), hn::LoadU(tag, current + w - 1));
    };
    if (w == 0) find(one, hn::Zero(one), hn::Zero(one));
    // As long as the words last; the last vector overlaps with the one before.
    const auto find_all = [&](auto tag) HWY_ATTR {
      const std::size_t lanes = hn::Lanes(tag);
      while (w < to && from + lanes < to) {
        w = std::min(w, to - lanes);
        find_next(tag);
      }
    };
    find_all(d);
    find_all(half);
    find_all(one);
    for (; active != 0; active &= active - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(active));
      writer.Write(events, i, (from + i) * bits_per_word);
    }
  }
  return static_cast<std::size_t>(writer.End() - runs);
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark::fast {

HWY_EXPORT(FindCrackRuns);

std::size_t find_crack_runs(const BitWord* above, const BitWord* current, int width,
                            Connectivity connectivity, std::span<CrackRun> runs) {
  return HWY_DYNAMIC_DISPATCH(FindCrackRuns)(above, current, width, connectivity == Connectivity::eight,
                                             runs.data());
}

}  // namespace runmark::fast
#endif
