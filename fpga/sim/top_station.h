#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "top_frames.h"

namespace runmark::rtl {

/// The bench, its processor's program and the C++ pipeline with the same settings.
template <class Bench>
class Station {
 public:
  Station(const Manners& manners, const Options& options, const Dictionary& codes, std::size_t records,
          std::uint32_t control, std::size_t memory_bytes = std::size_t{1} << 20)
      : bench(manners, memory_bytes),
        height_(options.max_height),
        filtered_(settings_of(options, codes, 0, 0, 0).filter != 0),
        by_register_((control & RUNMARK_CONTROL_READ_RESULTS) != 0),
        reference_(options, codes, records) {
    const runmark_settings settings =
        settings_of(options, codes, options.max_width, options.max_height, control);
    EXPECT_EQ(runmark_configure(&bench.device(), &settings), RUNMARK_OK);
    EXPECT_EQ(
        runmark_load_codes(&bench.device(), codes.codes.data(), static_cast<unsigned>(codes.codes.size())),
        RUNMARK_OK);
    runmark_run(&bench.device(), 1);
  }
  ~Station() { EXPECT_EQ(bench.faults(), std::vector<std::string>{}); }
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Runs the clock until a frame has ended; not for ever when nothing moves.
  std::optional<FrameOutcome> next_frame() {
    constexpr std::uint64_t patience = 5000000;
    std::size_t beats = bench.video().size();
    for (std::uint64_t until = bench.cycles() + patience; bench.cycles() < until;) {
      runmark_record record{};
      const bool result = next_record(record);
      if (result || bench.video().size() < beats) until = bench.cycles() + patience;
      beats = bench.video().size();
      if (!result) continue;
      if (auto outcome = collector_.add(record, height_, filtered_)) return outcome;
    }
    ADD_FAILURE() << "no frame ended";
    return {};
  }

  FrameOutcome plain(const Scene& scene) { return reference_.run(scene); }
  [[nodiscard]] const FrameStats& plain_stats() const { return reference_.stats(); }
  std::uint32_t count(std::uint32_t at) { return bench.read_register(at); }

  Bench bench;

 private:
  bool next_record(runmark_record& record) {
    if (by_register_) return runmark_next_result(&bench.device(), &record) != 0;
    bench.tick();
    const auto taken = bench.take_record();
    if (taken) record = taken->record;
    return taken.has_value();
  }

  int height_;
  bool filtered_;
  bool by_register_;
  Reference reference_;
  FrameCollector collector_;
};

}  // namespace runmark::rtl
