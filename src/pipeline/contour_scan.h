#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "contour/contour_linker.h"
#include "preprocess/run_scan.h"
#include "runmark/detector.h"

namespace runmark {

/// What a pipeline tells the preprocess and contour cores.
struct ContourRules {
  PreprocessRules preprocess;
  ChainLimits chains;
  std::size_t records = 65535;  ///< crack runs alive at once
};

/// Bit rows in, closed chains out: the preprocess and contour cores over one stream of rows.
class ContourScan {
 public:
  ContourScan(int max_width, const ContourRules& rules)
      : run_scan_(max_width, rules.preprocess),
        records_(rules.records),
        ends_(max_chain_ends(max_width)),
        end_at_(static_cast<std::size_t>(max_width) + 1),
        linker_(records_, ends_, end_at_, rules.chains) {}

  void begin_frame(int width, int height) {
    pixels_ = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    run_scan_.begin_frame(width, height);
    linker_.begin_frame();
  }

  /// Where the next row is to be written before `advance`.
  [[nodiscard]] BitWord* next_row() { return run_scan_.next_row(); }

  /// Takes the row written to next_row. The chains it closes go to `sink`.
  template <class Sink>
  void advance(Sink&& sink) {
    run_scan_.advance([&](int y, const BitWord*, std::span<const CrackRun> runs) {
      linker_.row(static_cast<std::uint16_t>(y), runs, sink);
    });
  }

  [[nodiscard]] const ContourLinker& linker() const { return linker_; }

  /// Adds what this frame came to.
  void add_counts(FrameStats& stats) const {
    const LinkerCounts& counts = linker_.counts();
    stats.pixels += pixels_;
    stats.crack_runs += counts.runs;
    stats.closed_chains += counts.closed;
    stats.dropped_chains += counts.dropped_full;
    stats.records_peak = std::max<std::uint64_t>(stats.records_peak, linker_.pool().peak());
  }
  [[nodiscard]] std::size_t memory() const {
    return run_scan_.memory() + records_.size() * sizeof(Record) + ends_.size() * sizeof(ChainEnd) +
           end_at_.size() * sizeof(EndIndex);
  }

 private:
  std::uint64_t pixels_ = 0;  // of the frame
  RunScan run_scan_;
  std::vector<Record> records_;
  std::vector<ChainEnd> ends_;
  std::vector<EndIndex> end_at_;
  ContourLinker linker_;
};

}  // namespace runmark
