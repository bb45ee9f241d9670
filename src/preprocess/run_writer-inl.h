// Included once for each of Highway's targets.
#if defined(RUNMARK_PREPROCESS_RUN_WRITER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RUNMARK_PREPROCESS_RUN_WRITER_INL_H
#undef RUNMARK_PREPROCESS_RUN_WRITER_INL_H
#else
#define RUNMARK_PREPROCESS_RUN_WRITER_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "preprocess/bit_row.h"
#include "preprocess/crack_run.h"

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What becomes of the cracks under some words of pixels: a bit for each column.
struct CrackEvents {
  static constexpr std::size_t most_words = bits_per_word;
  BitWord begins[most_words];
  BitWord ends[most_words];
  BitWord top[most_words];  // of the run that begins here
  BitWord left_above[most_words];
  BitWord right_above[most_words];
};

/// The runs of a row end in the order in which they begin, so beginnings and ends are written each for
/// itself: those of one word, from `begin` and from `end` on.
struct RunEnds {
  CrackRun* begin;
  CrackRun* end;
  std::size_t begin_count;
  std::size_t end_count;
};

#if HWY_TARGET == HWY_AVX3_DL
using Columns = hn::FixedTag<std::uint8_t, bits_per_word>;
using Eights = hn::Repartition<std::uint64_t, Columns>;
constexpr std::uint8_t first_mark = 0x40;
constexpr std::uint8_t second_mark = 0x80;
constexpr std::size_t at_a_time = 8;

/// Writes x0, top and left_above of eight runs and clears the rest, or writes only x1 and right_above.
/// @param ends  a byte of each run: its column, and what is known of this end in the upper two bits
template <bool begin>
HWY_INLINE void WriteEight(std::uint64_t ends, std::size_t column, CrackRun* runs) {
  static_assert(sizeof(CrackRun) == 8 && offsetof(CrackRun, x1) == 2 && offsetof(CrackRun, top) == 4 &&
                offsetof(CrackRun, left_above) == 5 && offsetof(CrackRun, right_above) == 6);
  const Columns d;
  const Eights words;
  // The byte of each run to where its column and its marks go.
  alignas(64) static constexpr auto places = [] {
    std::array<std::uint8_t, 64> all{};
    for (std::size_t i = 0; i < 64; ++i) {
      const std::size_t byte = i % 8;
      const bool used = begin ? byte == 0 || byte == 4 || byte == 5 : byte == 2 || byte == 6;
      all[i] = static_cast<std::uint8_t>(used ? i / 8 : 0x80);
    }
    return all;
  }();
  const auto placed =
      hn::TableLookupBytesOr0(hn::BitCast(d, hn::Set(words, ends)), hn::Load(d, places.data()));
  constexpr std::uint64_t columns = begin ? 0x3FULL : 0x3FULL << 16;
  constexpr std::uint64_t marks = begin ? std::uint64_t{first_mark} << 32 | std::uint64_t{second_mark} << 40
                                        : std::uint64_t{first_mark} << 48;
  const auto flags = hn::IfThenElseZero(hn::TestBit(placed, hn::BitCast(d, hn::Set(words, marks))),
                                        hn::Set(d, std::uint8_t{1}));
  const auto x = hn::Add(hn::And(hn::BitCast(words, placed), hn::Set(words, columns)),
                         hn::Set(words, begin ? column : column << 16));
  const auto written = hn::Or(hn::BitCast(d, x), flags);
  auto* to = reinterpret_cast<std::uint8_t*>(runs);
  if constexpr (begin) {
    hn::StoreU(written, d, to);
  } else {
    constexpr std::uint64_t end_fields = 0xFF0000FFFF0000;
    hn::BlendedStore(
        written, hn::TestBit(hn::BitCast(d, hn::Set(words, end_fields)), hn::Set(d, std::uint8_t{1})), d, to);
  }
}

template <bool begin>
HWY_INLINE void WriteAll(hn::Vec<Columns> ends, std::size_t count, std::size_t column, CrackRun* runs) {
  const Eights d;
  const auto eights = hn::BitCast(d, ends);
  WriteEight<begin>(hn::GetLane(eights), column, runs);
  if (HWY_LIKELY(count <= at_a_time)) return;
  std::uint64_t all[at_a_time];
  hn::StoreU(eights, d, all);
  for (std::size_t i = 1; i * at_a_time < count; ++i) {
    WriteEight<begin>(all[i], column, runs + i * at_a_time);
  }
}

/// The columns of a word's bits are gathered to the front of a vector, and eight runs are written at a time.
HWY_INLINE void WriteRuns(const CrackEvents& events, std::size_t word, std::size_t column, RunEnds runs) {
  const Columns d;
  const auto bits = [&](const BitWord& of)
                        HWY_ATTR { return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&of)); };
  const auto marked = [&](auto bytes, const BitWord& where, std::uint8_t mark) HWY_ATTR {
    return hn::IfThenElse(bits(where), hn::Or(bytes, hn::Set(d, mark)), bytes);
  };
  const auto columns = hn::Iota(d, 0);
  const auto begins =
      marked(marked(columns, events.top[word], first_mark), events.left_above[word], second_mark);
  const auto ends = marked(columns, events.right_above[word], first_mark);
  WriteAll<true>(hn::Compress(begins, bits(events.begins[word])), runs.begin_count, column, runs.begin);
  WriteAll<false>(hn::Compress(ends, bits(events.ends[word])), runs.end_count, column, runs.end);
}
#else
/// Most words have none to three of each: so many are written always, since the extra writes cost less than a
/// wrong guess of how many there are.
HWY_INLINE void WriteRuns(const CrackEvents& events, std::size_t word, std::size_t column, RunEnds runs) {
  constexpr std::size_t always = 3;
  BitWord begins = events.begins[word];
  BitWord ends = events.ends[word];
  const BitWord top = events.top[word];
  const BitWord left_above = events.left_above[word];
  const BitWord right_above = events.right_above[word];
  const auto x = static_cast<unsigned>(column);
  const auto write = [&]() HWY_ATTR {
    const int b = std::countr_zero(begins) & (bits_per_word - 1);
    runs.begin->x0 = static_cast<std::uint16_t>(x + static_cast<unsigned>(b));
    runs.begin->top = (top >> b & 1U) != 0;
    runs.begin->left_above = (left_above >> b & 1U) != 0;
    ++runs.begin;
    begins &= begins - 1;
    const int e = std::countr_zero(ends) & (bits_per_word - 1);
    runs.end->x1 = static_cast<std::uint16_t>(x + static_cast<unsigned>(e));
    runs.end->right_above = (right_above >> e & 1U) != 0;
    ++runs.end;
    ends &= ends - 1;
  };
  for (std::size_t i = 0; i < always; ++i) write();
  for (std::size_t i = std::max(runs.begin_count, runs.end_count); i > always; --i) write();
}
#endif

/// Writes the runs of a row, word by word.
class RunWriter {
 public:
  explicit RunWriter(CrackRun* runs) : next_begin_(runs), next_end_(runs) {}

  HWY_INLINE void Write(const CrackEvents& events, std::size_t word, std::size_t column) {
    const RunEnds runs{next_begin_, next_end_, static_cast<std::size_t>(std::popcount(events.begins[word])),
                       static_cast<std::size_t>(std::popcount(events.ends[word]))};
    next_begin_ += runs.begin_count;
    next_end_ += runs.end_count;
    WriteRuns(events, word, column, runs);
  }

  [[nodiscard]] CrackRun* End() const { return next_end_; }

 private:
  CrackRun* next_begin_;
  CrackRun* next_end_;
};

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
