#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contour/contour_linker.h"
#include "preprocess/border.h"
#include "preprocess/crack_runs_fast.h"
#include "preprocess/filter.h"
#include "preprocess/specks_fast.h"
#include "runmark/detector.h"

namespace runmark {

/// What a pipeline tells the preprocess and contour cores.
struct ContourRules {
  std::uint8_t filter_cases = filter_none;
  Connectivity connectivity = Connectivity::four;
  ChainLimits chains;
  std::size_t records = 65535;  ///< crack runs alive at once
  bool drop_specks = false;     ///< without a filter: single pixels, whose contours the limits drop
};

/// Bit rows in, closed chains out: the preprocess and contour cores over one stream of rows.
class ContourScan {
 public:
  ContourScan(int max_width, const ContourRules& rules)
      : connectivity_(rules.connectivity),
        filter_cases_(rules.filter_cases),
        drop_specks_(rules.drop_specks),
        records_(rules.records),
        ends_(max_chain_ends(max_width)),
        end_at_(static_cast<std::size_t>(max_width) + 1),
        runs_(max_crack_runs(max_width) + fast::crack_runs_slack),
        linker_(records_, ends_, end_at_, rules.chains) {
    for (auto& row : raw_) row.resize(bit_words(max_width));
    for (auto& row : clean_) row.resize(bit_words(max_width));
  }

  void begin_frame(int width, int height) {
    width_ = width;
    height_ = height;
    y_ = 0;
    for (auto& row : raw_) std::fill(row.begin(), row.end(), BitWord{0});
    for (auto& row : clean_) std::fill(row.begin(), row.end(), BitWord{0});
    linker_.begin_frame();
  }

  /// Where the next row is to be written before `advance`.
  [[nodiscard]] BitWord* next_row() { return raw_[2].data(); }

  /// Takes the row written to next_row. The chains it closes go to `sink`. Where rows are cleaned the
  /// contours run one row late, since a row is cleaned when the row below it is in.
  template <class Sink>
  void advance(Sink&& sink) {
    clear_border(raw_[2].data(), width_, y_, height_);
    if (filter_cases_ == 0 && !drop_specks_) {
      follow(raw_[1].data(), raw_[2].data(), y_, sink);
    } else if (y_ > 0) {
      clean();
      follow(clean_[0].data(), clean_[1].data(), y_ - 1, sink);
      std::swap(clean_[0], clean_[1]);
      if (y_ + 1 == height_) {
        follow(clean_[0].data(), raw_[2].data(), y_,
               sink);  // the last row is border: white, nothing to clean
      }
    }
    std::rotate(raw_.begin(), raw_.begin() + 1, raw_.end());
    ++y_;
  }

  [[nodiscard]] const ContourLinker& linker() const { return linker_; }

  /// Adds what this frame came to.
  void add_counts(FrameStats& stats) const {
    const LinkerCounts& counts = linker_.counts();
    stats.pixels += static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(height_);
    stats.crack_runs += counts.runs;
    stats.closed_chains += counts.closed;
    stats.dropped_chains += counts.dropped_full;
    stats.records_peak = std::max<std::uint64_t>(stats.records_peak, linker_.pool().peak());
  }
  [[nodiscard]] std::size_t memory() const {
    return records_.size() * sizeof(Record) + ends_.size() * sizeof(ChainEnd) +
           end_at_.size() * sizeof(EndIndex) + runs_.size() * sizeof(CrackRun) +
           5 * raw_[0].size() * sizeof(BitWord);
  }

 private:
  /// The row before the one just taken, from raw_ to clean_.
  void clean() {
    const auto& [above, current, below] = raw_;
    BitWord* to = clean_[1].data();
    if (filter_cases_ != 0) {
      filter_row(above.data(), current.data(), below.data(), width_, filter_cases_, to);
    } else {
      fast::drop_specks(above.data(), current.data(), below.data(), width_, connectivity_, to);
    }
  }

  template <class Sink>
  void follow(const BitWord* above, const BitWord* current, int y, Sink&& sink) {
    const std::size_t count = fast::find_crack_runs(above, current, width_, connectivity_, runs_);
    linker_.row(static_cast<std::uint16_t>(y), std::span<const CrackRun>(runs_).first(count), sink);
  }

  Connectivity connectivity_;
  std::uint8_t filter_cases_;
  bool drop_specks_;
  int width_ = 0;
  int height_ = 0;
  int y_ = 0;
  std::array<std::vector<BitWord>, 3> raw_;    // above, current, next
  std::array<std::vector<BitWord>, 2> clean_;  // cleaned: above, current
  std::vector<Record> records_;
  std::vector<ChainEnd> ends_;
  std::vector<EndIndex> end_at_;
  std::vector<CrackRun> runs_;
  ContourLinker linker_;
};

}  // namespace runmark
