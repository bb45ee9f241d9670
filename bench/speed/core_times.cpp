#include "bench/speed/core_times.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <span>

#include "bench/cpu_clock.h"
#include "bench/speed/workers.h"
#include "corner/quad_from_chain.h"
#include "evaluate/percentile.h"
#include "pipeline/halve_fast.h"
#include "pipeline/octave.h"
#include "pipeline/row_store.h"
#include "pipeline/scale_rules.h"
#include "preprocess/run_scan.h"

namespace runmark::bench {
namespace {

/// The threshold core over the rows of one scale and, if asked for, the crack runs of its bits.
class BitScan {
 public:
  BitScan(int width, int height, const ScaleRules& rules, bool crack_runs)
      : width_(width),
        height_(height),
        rules_(rules),
        crack_runs_(crack_runs),
        threshold_(width),
        scan_(width, rules.contours.preprocess) {}

  void begin_frame() {
    rows_ = 0;
    threshold_.begin_frame(width_, rules_.tiles);
    scan_.begin_frame(width_, height_);
  }

  void push(const std::uint8_t* grey) {
    const auto slot = static_cast<std::size_t>(rows_ % tile_side);
    fresh_[slot] = grey;
    ++rows_;
    if (rows_ < height_ && slot + 1 < tile_side) return;
    for (std::size_t i = slot + 1; i < tile_side; ++i) fresh_[i] = grey;
    threshold_.add_band(fresh_);
    if (rows_ > tile_side) follow(tile_side);
    waiting_ = fresh_;
    if (rows_ < height_) return;
    threshold_.finish();
    follow(slot + 1);
  }

 private:
  void follow(std::size_t rows) {
    for (std::size_t i = 0; i < rows; ++i) {
      fast::threshold_row(waiting_[i], width_, threshold_.levels(), scan_.next_row());
      if (crack_runs_) scan_.advance([](int, const BitWord*, std::span<const CrackRun>) {});
    }
  }

  int width_;
  int height_;
  ScaleRules rules_;
  bool crack_runs_;
  int rows_ = 0;
  TileBand fresh_{};
  TileBand waiting_{};
  TileThreshold threshold_;
  RunScan scan_;
};

/// Hands every row of every scale to `push(level, row)`, halving as the default pipeline does.
class Scales {
 public:
  Scales(int width, int height, const Options& options) {
    for (int level = 0; level <= options.octaves && scale_is_used(level, width, height); ++level) {
      scales_.push_back({width, height, RowStore(width, 9), scale_rules(options, level, false)});
      width /= 2;
      height /= 2;
    }
  }
  struct Scale {
    int width;
    int height;
    RowStore rows;
    ScaleRules rules;
  };
  [[nodiscard]] std::vector<Scale>& all() { return scales_; }

  template <class Push>
  void run(const cv::Mat& grey, Push&& push) {
    for (int y = 0; y < grey.rows; ++y) push_row(0, grey.ptr(y), y > 0 ? grey.ptr(y - 1) : nullptr, y, push);
  }

 private:
  template <class Push>
  void push_row(std::size_t level, const std::uint8_t* grey, const std::uint8_t* upper, int y, Push&& push) {
    push(level, grey);
    if (level + 1 == scales_.size() || y % 2 == 0 || y / 2 >= scales_[level + 1].height) return;
    Scale& next = scales_[level + 1];
    std::uint8_t* half = next.rows.row(y / 2);
    fast::halve_rows(upper, grey, next.width, half);
    const std::uint8_t* above = y / 2 > 0 ? next.rows.row(y / 2 - 1) : nullptr;
    push_row(level + 1, half, above, y / 2, push);
  }

  std::vector<Scale> scales_;
};

using Work = std::function<void()>;

Work bit_work(const cv::Mat& grey, const Options& options, bool crack_runs) {
  auto scales = std::make_shared<Scales>(grey.cols, grey.rows, options);
  auto scans = std::make_shared<std::vector<BitScan>>();
  for (const auto& scale : scales->all()) {
    scans->emplace_back(scale.width, scale.height, scale.rules, crack_runs);
  }
  return [=] {
    for (BitScan& scan : *scans) scan.begin_frame();
    scales->run(grey, [&](std::size_t level, const std::uint8_t* row) { (*scans)[level].push(row); });
  };
}

Work contour_work(const cv::Mat& grey, const Options& options, bool corners) {
  auto scales = std::make_shared<Scales>(grey.cols, grey.rows, options);
  auto octaves = std::make_shared<std::vector<Octave>>();
  octaves->reserve(scales->all().size());  // an octave's linker refers to its memory
  for (const auto& scale : scales->all()) octaves->emplace_back(scale.width, scale.rules.contours);
  auto outline = std::make_shared<Outline>(max_vertices(ChainLimits{}));
  return [=] {
    for (std::size_t i = 0; i < octaves->size(); ++i) {
      const auto& scale = scales->all()[i];
      (*octaves)[i].begin_frame(scale.width, scale.height, scale.rules.tiles);
    }
    scales->run(grey, [&](std::size_t level, const std::uint8_t* row) {
      (*octaves)[level].push(row, [&](const ClosedChain& chain) {
        if (corners) static_cast<void>(quad_from_chain(chain, scales->all()[level].rules.quads, *outline));
      });
    });
  };
}

}  // namespace

std::vector<CoreTime> core_times(const TimedFrame& frame, int rounds) {
  Options options;
  options.max_width = frame.grey.cols;
  options.max_height = frame.grey.rows;
  const std::array<Work, 5> further{bit_work(frame.grey, options, false), bit_work(frame.grey, options, true),
                                    contour_work(frame.grey, options, false),
                                    contour_work(frame.grey, options, true),
                                    reader_for("runmark", frame).work};
  std::array<std::vector<double>, 5> times;
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < further.size(); ++i) {
      const double start = cpu_milliseconds();
      further[i]();
      if (round > 0) times[i].push_back(cpu_milliseconds() - start);
    }
  }
  std::vector<CoreTime> result;
  double before = 0;
  for (std::size_t i = 0; i < further.size(); ++i) {
    constexpr std::array names{"threshold", "preprocess", "contour", "corner", "pattern"};
    std::ranges::sort(times[i]);
    const double now = percentile(times[i], 0.5);
    result.push_back({names[i], std::max(now - before, 0.0)});
    before = std::max(now, before);
  }
  return result;
}

}  // namespace runmark::bench
