#pragma once

#include <cstdint>
#include <vector>

#include "marker_scene.h"
#include "preprocess/border.h"
#include "preprocess/crack_runs.h"
#include "preprocess/filter.h"
#include "threshold/fixed_threshold.h"

namespace runmark::rtl {

/// The inputs of the contour core in one frame, by kind.
struct EventCounts {
  std::uint64_t straights = 0;
  std::uint64_t shifts = 0;
  std::uint64_t starts = 0;
  std::uint64_t joins = 0;

  [[nodiscard]] std::uint64_t runs() const { return shifts + starts + joins; }
  [[nodiscard]] std::uint64_t all() const { return straights + runs(); }
  /// Clocks the contour core needs for them, as docs/hardware.md states. `closed` of the joins close.
  [[nodiscard]] std::uint64_t clocks(std::uint64_t closed) const {
    return straights + 3 * shifts + 4 * starts + 6 * closed + 10 * (joins - closed);
  }
};

/// Counts them by the plain cores: threshold, white border, the whole filter, crack runs, eight-connected.
inline EventCounts count_events(const Scene& scene, const FixedThreshold& threshold) {
  const std::size_t words = bit_words(scene.width);
  std::vector<std::vector<BitWord>> raw(3, std::vector<BitWord>(words));
  std::vector<std::vector<BitWord>> clean(2, std::vector<BitWord>(words));
  std::vector<CrackRun> runs(max_crack_runs(scene.width));
  EventCounts counts;
  for (int y = 0; y <= scene.height; ++y) {
    std::fill(raw[2].begin(), raw[2].end(), BitWord{0});
    if (y < scene.height) {
      threshold_row(scene.grey.data() + static_cast<std::ptrdiff_t>(y) * scene.width, scene.width, threshold,
                    raw[2].data());
      clear_border(raw[2].data(), scene.width, y, scene.height);
    }
    filter_row(raw[0].data(), raw[1].data(), raw[2].data(), scene.width, filter_all, clean[1].data());
    const std::size_t found =
        find_crack_runs(clean[0].data(), clean[1].data(), scene.width, Connectivity::eight, runs);
    for (std::size_t i = 0; i < found; ++i) {
      const bool above = runs[i].left_above;
      if (above != runs[i].right_above) {
        ++counts.shifts;
      } else {
        ++(above ? counts.joins : counts.starts);
      }
    }
    for (int x = 1; x < scene.width; ++x) {
      const bool left = bit_at(clean[1].data(), x - 1);
      const bool right = bit_at(clean[1].data(), x);
      counts.straights +=
          left != right && left == bit_at(clean[0].data(), x - 1) && right == bit_at(clean[0].data(), x);
    }
    raw[0].swap(raw[1]);
    raw[1].swap(raw[2]);
    clean[0].swap(clean[1]);
  }
  return counts;
}

}  // namespace runmark::rtl
