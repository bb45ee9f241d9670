#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "contour/chain.h"
#include "contour/chain_end.h"
#include "contour/record_pool.h"
#include "preprocess/crack_run.h"

namespace runmark {

/// How many open ends a row of that width can have, which is the size of the end table.
[[nodiscard]] constexpr std::size_t max_chain_ends(int width) { return static_cast<std::size_t>(width) + 2; }

/// What one frame made the linker do and drop.
struct LinkerCounts {
  std::uint64_t runs = 0;          ///< crack runs taken in
  std::uint64_t closed = 0;        ///< contours that closed, dropped ones included
  std::uint64_t handed_on = 0;     ///< closed chains given to the sink
  std::uint64_t dropped_full = 0;  ///< chains given up because no record was free
  std::uint64_t dropped_rule = 0;  ///< chains given up by ChainLimits
};

/// Links crack runs to closed chains, all at once as the rows go by, without labels (docs/design.md,
/// contours from crack events; after Bailey, "Chain coding streamed images through crack run-length
/// encoding", IVCNZ 2010). Every open end stands in `end_at` at its crack and knows its partner, so a
/// join takes constant time. All memory is the caller's.
class ContourLinker {
 public:
  /// @param records  pool of at most 65535
  /// @param ends     max_chain_ends(width) entries
  /// @param end_at   width + 1 entries, one a crack
  ContourLinker(std::span<Record> records, std::span<ChainEnd> ends, std::span<EndIndex> end_at,
                const ChainLimits& limits)
      : pool_(records), ends_(ends), end_at_(end_at), limits_(limits) {
    begin_frame();
  }

  /// Forgets every chain.
  void begin_frame() {
    pool_.reset();
    counts_ = {};
    free_end_ = no_end;
    untouched_ends_ = 0;
    open_ends_ = 0;
  }

  /// Takes the runs of one row in order. `sink(const ClosedChain&)` is called for every contour that
  /// closes and obeys the limits. Row y's runs lie on crack line y.
  template <class Sink>
  void row(std::uint16_t y, std::span<const CrackRun> runs, Sink&& sink) {
    if (runs.empty()) return;
    EndIndex next_left = end_at_[runs[0].x0];
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const CrackRun& run = runs[i];
      const EndIndex left = next_left;
      const EndIndex right = end_at_[run.x1];
      // Where two runs touch, this one may overwrite the end that the next one is to read.
      if (i + 1 < runs.size()) next_left = end_at_[runs[i + 1].x0];
      if (run.left_above != run.right_above) {
        shift(run, y, left, right);
      } else if (run.left_above) {
        join(run, y, left, right, sink);
      } else {
        start(run, y);
      }
    }
    counts_.runs += runs.size();
  }

  /// Gives up every open chain, as when a run was lost: the rest of the frame must not be read.
  void abandon() {
    counts_.dropped_full += open_ends_ / 2;
    pool_.reset();
    free_end_ = no_end;
    untouched_ends_ = 0;
    open_ends_ = 0;
  }

  [[nodiscard]] const LinkerCounts& counts() const { return counts_; }
  [[nodiscard]] const RecordPool& pool() const { return pool_; }
  [[nodiscard]] std::size_t open_ends() const { return open_ends_; }

 private:
  static constexpr EndIndex no_end = 0xFFFF;

  /// Where a run is left: top runs are followed to the right, bottom runs to the left.
  static std::uint16_t exit_of(const CrackRun& run) { return chosen(run.top, run.x1, run.x0); }

  /// `condition ? a : b` without a branch: in noise the processor would guess wrongly half of the time.
  static std::uint16_t chosen(bool condition, std::uint16_t a, std::uint16_t b) {
    return static_cast<std::uint16_t>(b ^ ((a ^ b) & -static_cast<int>(condition)));
  }

  EndIndex take_end() {
    ++open_ends_;
    if (free_end_ == no_end) return static_cast<EndIndex>(untouched_ends_++);
    const EndIndex index = free_end_;
    free_end_ = ends_[index].partner;
    return index;
  }

  void give_back_end(EndIndex index) {
    --open_ends_;
    ends_[index].partner = free_end_;
    free_end_ = index;
  }

  /// A boundary goes on, shifted sideways from the crack above to the crack below.
  void shift(const CrackRun& run, std::uint16_t y, EndIndex left, EndIndex right) {
    const EndIndex index = chosen(run.left_above, left, right);
    end_at_[chosen(run.left_above, run.x1, run.x0)] = index;
    ChainEnd& end = ends_[index];
    if (end.dead) return;
    const bool append = run.top == run.left_above;
    const RecordIndex record = pool_.take(exit_of(run), y, no_record);
    if (record == no_record) return give_up(index, counts_.dropped_full);
    pool_.link(chosen(append, end.record, record), chosen(append, record, end.record));
    end.record = record;
    ++end.records;
    if (limits_.drop_early && end.records > limits_.max_records) give_up(index, counts_.dropped_rule);
  }

  /// A new chain hangs down from both ends of the run.
  void start(const CrackRun& run, std::uint16_t y) {
    const EndIndex left = take_end();
    const EndIndex right = take_end();
    end_at_[run.x0] = left;
    end_at_[run.x1] = right;
    const RecordIndex record = pool_.take(exit_of(run), y, no_record);
    const bool dead = record == no_record;
    if (dead) ++counts_.dropped_full;
    ends_[left] = {right, record, 1, 1, y, dead};
    ends_[right] = {left, record, 0, 0, y, dead};
  }

  /// Two ends meet: of one chain, which closes, or of two, which become one.
  template <class Sink>
  void join(const CrackRun& run, std::uint16_t y, EndIndex left, EndIndex right, Sink&& sink) {
    const EndIndex down = chosen(run.top, left, right);
    const EndIndex up = chosen(run.top, right, left);
    const bool closes = !ends_[down].dead && !ends_[up].dead && ends_[down].partner == up;
    if (closes) {
      close(run, y, down, up, sink);
    } else {
      connect(run, y, down, up);
    }
    give_back_end(left);
    give_back_end(right);
  }

  template <class Sink>
  void close(const CrackRun& run, std::uint16_t y, EndIndex down, EndIndex up, Sink&& sink) {
    ++counts_.closed;
    const ChainEnd& tail = ends_[down];
    const ChainEnd& head = ends_[up];
    const RecordIndex record = pool_.take(exit_of(run), y, no_record);
    if (record == no_record) return give_up(down, counts_.dropped_full);
    pool_.link(tail.record, record);
    ClosedChain chain{&pool_,
                      head.record,
                      record,
                      head.records + tail.records + 1,
                      head.turns + tail.turns + 1,
                      std::min(head.top, tail.top),
                      y,
                      run.top};
    const bool obeys = chain.turns <= limits_.max_turns && chain.records <= limits_.max_records &&
                       chain.bottom - chain.top >= limits_.min_height && (limits_.holes || !chain.hole);
    if (obeys) {
      ++counts_.handed_on;
      sink(static_cast<const ClosedChain&>(chain));
    } else {
      ++counts_.dropped_rule;
    }
    pool_.give_back(chain.head, chain.tail, chain.records);
  }

  void connect(const CrackRun& run, std::uint16_t y, EndIndex down, EndIndex up) {
    if (ends_[down].dead || ends_[up].dead) {
      if (!ends_[down].dead) give_up(down, counts_.dropped_rule);
      if (!ends_[up].dead) give_up(up, counts_.dropped_rule);
      return;
    }
    const RecordIndex record = pool_.take(exit_of(run), y, ends_[up].record);
    if (record == no_record) {
      give_up(down, counts_.dropped_full);
      give_up(up, counts_.dropped_full);
      return;
    }
    pool_.link(ends_[down].record, record);
    const EndIndex new_up = ends_[down].partner;
    const EndIndex new_down = ends_[up].partner;
    add_half(ends_[new_up], ends_[down]);
    add_half(ends_[new_down], ends_[up]);
    ends_[new_up].partner = new_down;
    ends_[new_down].partner = new_up;
    ++ends_[new_up].records;
    ++ends_[new_up].turns;
    const bool broken = ends_[new_up].turns + ends_[new_down].turns > limits_.max_turns ||
                        ends_[new_up].records + ends_[new_down].records > limits_.max_records;
    if (limits_.drop_early && broken) give_up(new_up, counts_.dropped_rule);
  }

  static void add_half(ChainEnd& into, const ChainEnd& half) {
    into.records += half.records;
    into.turns += half.turns;
    into.top = std::min(into.top, half.top);
  }

  /// The chain's records are free again; its two ends go on as dead ones.
  void give_up(EndIndex index, std::uint64_t& counter) {
    ++counter;
    ChainEnd& one = ends_[index];
    ChainEnd& other = ends_[one.partner];
    const std::size_t records = one.records + other.records;
    // Which of the two is the list's head does not matter to its owner, but the list runs one way.
    const bool one_is_tail = pool_[one.record].next == no_record;
    pool_.give_back(one_is_tail ? other.record : one.record, one_is_tail ? one.record : other.record,
                    records);
    one.dead = true;
    other.dead = true;
  }

  RecordPool pool_;
  std::span<ChainEnd> ends_;
  std::span<EndIndex> end_at_;
  ChainLimits limits_;
  LinkerCounts counts_;
  EndIndex free_end_ = no_end;
  std::size_t untouched_ends_ = 0;
  std::size_t open_ends_ = 0;
};

}  // namespace runmark
