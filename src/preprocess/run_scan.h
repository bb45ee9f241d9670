#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "preprocess/border.h"
#include "preprocess/crack_runs_fast.h"
#include "preprocess/filter.h"
#include "preprocess/specks_fast.h"

namespace runmark {

/// What a pipeline tells the preprocess core.
struct PreprocessRules {
  std::uint8_t filter_cases = filter_none;
  Connectivity connectivity = Connectivity::four;
  bool drop_specks = false;  ///< without a filter: single pixels, whose contours nobody wants
};

/// The preprocess core over one stream of rows: bit rows in, their crack runs out.
class RunScan {
 public:
  RunScan(int max_width, const PreprocessRules& rules)
      : rules_(rules), runs_(max_crack_runs(max_width) + fast::crack_runs_slack) {
    for (auto& row : raw_) row.resize(bit_words(max_width));
    for (auto& row : clean_) row.resize(bit_words(max_width));
  }

  void begin_frame(int width, int height) {
    width_ = width;
    height_ = height;
    y_ = 0;
    for (auto& row : raw_) std::fill(row.begin(), row.end(), BitWord{0});
    for (auto& row : clean_) std::fill(row.begin(), row.end(), BitWord{0});
  }

  /// Where the next row is to be written before `advance`.
  [[nodiscard]] BitWord* next_row() { return raw_[2].data(); }

  /// Takes the row written to next_row. `sink(y, row, runs)` gets each row as it is followed, with the runs
  /// on crack line y above it. Where rows are cleaned that is one row late, since a row is cleaned when the
  /// row below it is in.
  template <class Sink>
  void advance(Sink&& sink) {
    clear_border(raw_[2].data(), width_, y_, height_);
    if (rules_.filter_cases == 0 && !rules_.drop_specks) {
      hand_on(y_, raw_[1].data(), raw_[2].data(), sink);
    } else if (y_ > 0) {
      clean();
      hand_on(y_ - 1, clean_[0].data(), clean_[1].data(), sink);
      std::swap(clean_[0], clean_[1]);
      // The last row is border: white, nothing to clean.
      if (y_ + 1 == height_) hand_on(y_, clean_[0].data(), raw_[2].data(), sink);
    }
    std::rotate(raw_.begin(), raw_.begin() + 1, raw_.end());
    ++y_;
  }

  [[nodiscard]] std::size_t memory() const {
    return runs_.size() * sizeof(CrackRun) + 5 * raw_[0].size() * sizeof(BitWord);
  }

 private:
  /// The row before the one just taken, from raw_ to clean_.
  void clean() {
    const auto& [above, current, below] = raw_;
    BitWord* to = clean_[1].data();
    if (rules_.filter_cases != 0) {
      filter_row(above.data(), current.data(), below.data(), width_, rules_.filter_cases, to);
    } else {
      fast::drop_specks(above.data(), current.data(), below.data(), width_, rules_.connectivity, to);
    }
  }

  template <class Sink>
  void hand_on(int y, const BitWord* above, const BitWord* row, Sink&& sink) {
    const std::size_t count = fast::find_crack_runs(above, row, width_, rules_.connectivity, runs_);
    sink(y, row, std::span<const CrackRun>(runs_).first(count));
  }

  PreprocessRules rules_;
  int width_ = 0;
  int height_ = 0;
  int y_ = 0;
  std::array<std::vector<BitWord>, 3> raw_;    // above, current, next
  std::array<std::vector<BitWord>, 2> clean_;  // cleaned: above, current
  std::vector<CrackRun> runs_;
};

}  // namespace runmark
