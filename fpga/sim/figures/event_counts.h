#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "marker_scene.h"
#include "pipeline/contour_scan.h"
#include "preprocess/run_scan.h"
#include "runmark/options.h"
#include "threshold/fixed_threshold.h"
#include "threshold/integer_tiles.h"

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

using BitRows = std::vector<std::vector<BitWord>>;

/// What the plain threshold core of the options' pipeline makes of a scene, its border light.
inline BitRows dark_rows(const Scene& scene, const Options& options) {
  BitRows rows(static_cast<std::size_t>(scene.height), std::vector<BitWord>(bit_words(scene.width)));
  const auto grey = [&](int y) { return scene.grey.data() + static_cast<std::ptrdiff_t>(y) * scene.width; };
  const auto row = [&](int y) { return rows[static_cast<std::size_t>(y)].data(); };
  IntegerTiles tiles(scene.width);
  tiles.begin_frame(scene.width, scene.height, options.min_contrast);
  const auto take_tiles = [&] {
    for (int y = tiles.ready_from(); y < tiles.ready_to(); ++y) tiles.threshold(grey(y), row(y));
  };
  for (int y = 0; y < scene.height; ++y) {
    if (options.pipeline == Pipeline::hardware) {
      if (tiles.add_row(grey(y))) take_tiles();
    } else {
      threshold_row(grey(y), scene.width, {options.fixed_threshold, options.above_is_dark}, row(y));
    }
  }
  if (options.pipeline == Pipeline::hardware) {
    tiles.finish();
    take_tiles();
  }
  for (int y = 0; y < scene.height; ++y) clear_border(row(y), scene.width, y, scene.height);
  return rows;
}

/// Counts them by the preprocess core.
inline EventCounts count_events(const BitRows& dark, int width, const ContourRules& rules) {
  EventCounts counts;
  std::vector<BitWord> above(bit_words(width));
  RunScan scan(width, rules.preprocess);
  scan.begin_frame(width, static_cast<int>(dark.size()));
  for (const auto& next : dark) {
    std::ranges::copy(next, scan.next_row());
    scan.advance([&](int, const BitWord* row, std::span<const CrackRun> runs) {
      for (const CrackRun& run : runs) {
        if (run.left_above != run.right_above) {
          ++counts.shifts;
        } else {
          ++(run.left_above ? counts.joins : counts.starts);
        }
      }
      for (int x = 1; x < width; ++x) {
        const bool left = bit_at(row, x - 1);
        const bool right = bit_at(row, x);
        counts.straights +=
            left != right && left == bit_at(above.data(), x - 1) && right == bit_at(above.data(), x);
      }
      std::copy_n(row, above.size(), above.begin());
    });
  }
  return counts;
}

}  // namespace runmark::rtl
