#include "preprocess/crack_runs_fast.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "preprocess/crack_runs_fast.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

/// A run's end belongs to the row above or to the current one, as the pixel beyond it tells. There the two
/// rows agree, except where runs touch crosswise: then it matters at which row a top run looks and at which
/// a bottom run, and that is the connectivity.
///
/// The runs of a row end in the order in which they begin, so beginnings and ends are written each for
/// itself. Most words have none to three of each: so many are written always, since the extra writes cost
/// less than a wrong guess of how many there are.
std::size_t FindCrackRuns(const BitWord* above, const BitWord* current, int width, bool eight,
                          CrackRun* runs) {
  constexpr int last_bit = bits_per_word - 1;
  constexpr int always = 3;
  const BitWord* top_sees = eight ? above : current;
  const BitWord* bottom_sees = eight ? current : above;
  const std::size_t words = bit_words(width);
  CrackRun* next_begin = runs;
  CrackRun* next_end = runs;
  BitWord top_before = 0;  // the last column of the word before, as bit 0
  BitWord bottom_before = 0;
  BitWord top_sees_before = 0;
  BitWord bottom_sees_before = 0;

  for (std::size_t w = 0; w < words; ++w) {
    const BitWord top = current[w] & ~above[w];
    const BitWord bottom = above[w] & ~current[w];
    // The same, one column on: what is left of each crack.
    const BitWord left_top = (top << 1) | top_before;
    const BitWord left_bottom = (bottom << 1) | bottom_before;
    const BitWord left_top_sees = (top_sees[w] << 1) | top_sees_before;
    const BitWord left_bottom_sees = (bottom_sees[w] << 1) | bottom_sees_before;
    top_before = top >> last_bit;
    bottom_before = bottom >> last_bit;
    top_sees_before = top_sees[w] >> last_bit;
    bottom_sees_before = bottom_sees[w] >> last_bit;

    BitWord begins = (top & ~left_top) | (bottom & ~left_bottom);
    BitWord ends = (left_top & ~top) | (left_bottom & ~bottom);
    if ((begins | ends) == 0) continue;
    const BitWord left_above = (top & left_top_sees) | (bottom & ~left_bottom_sees);
    const BitWord right_above = (left_top & top_sees[w]) | (left_bottom & ~bottom_sees[w]);
    const auto x = static_cast<unsigned>(w) * bits_per_word;
    CrackRun* begin = next_begin;
    CrackRun* end = next_end;
    const int begin_count = std::popcount(begins);
    const int end_count = std::popcount(ends);
    next_begin += begin_count;
    next_end += end_count;
    const auto write = [&]() HWY_ATTR {
      const int b = std::countr_zero(begins) & last_bit;
      begin->x0 = static_cast<std::uint16_t>(x + static_cast<unsigned>(b));
      begin->top = (top >> b & 1U) != 0;
      begin->left_above = (left_above >> b & 1U) != 0;
      ++begin;
      begins &= begins - 1;
      const int e = std::countr_zero(ends) & last_bit;
      end->x1 = static_cast<std::uint16_t>(x + static_cast<unsigned>(e));
      end->right_above = (right_above >> e & 1U) != 0;
      ++end;
      ends &= ends - 1;
    };
    for (int i = 0; i < always; ++i) write();
    for (int i = std::max(begin_count, end_count); i > always; --i) write();
  }
  return static_cast<std::size_t>(next_end - runs);
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
