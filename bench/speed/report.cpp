#include "bench/speed/report.h"

#include <cstdio>

namespace runmark::bench {
namespace {

void print_table(const FrameSet& set, const std::vector<Timing>& timings, int rounds) {
  std::printf("%s: %zu frames, %.1f markers a frame, %d rounds, CPU ms a frame\n", set.name.c_str(),
              set.frames.size(), set.markers_per_frame(), rounds);
  std::printf("  %-20s %10s %10s %10s %12s\n", "", "median", "p95", "worst", "to runmark");
  const double ours = timing_of(timings, "runmark").median();
  for (const Timing& t : timings) {
    std::printf("  %-20s %10.4f %10.4f %10.4f %11.3fx\n", t.worker.c_str(), t.median(), t.p95(), t.worst(),
                t.median() / ours);
  }
}

void print_cores(const std::vector<CoreTime>& cores) {
  double sum = 0;
  for (const CoreTime& core : cores) sum += core.milliseconds;
  std::printf("  cores:");
  for (const CoreTime& core : cores)
    std::printf(" %s %.0f %%", core.core.c_str(), 100 * core.milliseconds / sum);
  std::printf("\n");
}

void print_spread(const Timing& spread) {
  std::printf("  runmark over %zu frames: median %.4f, p95 %.4f (%.2f medians), worst %.4f\n",
              spread.milliseconds.size(), spread.median(), spread.p95(), spread.p95() / spread.median(),
              spread.worst());
}

void print_noise(const NoiseSweep& noise, double median) {
  std::printf("  noise: worst of %zu kinds %.1f times the median; %.2f MB of memory\n", noise.cells.size(),
              noise.worst() / median, static_cast<double>(noise.memory) / 1e6);
}

nlohmann::ordered_json to_json(const NoiseSweep& noise, double median) {
  nlohmann::ordered_json cells = nlohmann::ordered_json::array();
  for (const NoiseCell& cell : noise.cells) {
    cells.push_back({{"density", cell.density},
                     {"granularity", cell.granularity},
                     {"ms", cell.milliseconds},
                     {"over_median", cell.milliseconds / median},
                     {"crack_runs", cell.crack_runs},
                     {"records_peak", cell.records_peak},
                     {"dropped_chains", cell.dropped_chains}});
  }
  return {{"worst_over_median", noise.worst() / median}, {"memory", noise.memory}, {"cells", cells}};
}

}  // namespace

void print(const FrameSet& set, const Figures& figures, int rounds) {
  print_table(set, figures.timings, rounds);
  print_spread(figures.spread);
  print_cores(figures.cores);
  if (figures.noise) print_noise(*figures.noise, timing_of(figures.timings, "runmark").median());
}

nlohmann::ordered_json to_json(const FrameSet& set, const Figures& figures, int rounds) {
  const std::vector<Timing>& timings = figures.timings;
  const auto median = [&](const char* worker) { return timing_of(timings, worker).median(); };
  const Timing& ours = timing_of(timings, "runmark");
  nlohmann::ordered_json entry{{"size", set.name},
                               {"frames", set.frames.size()},
                               {"markers_per_frame", set.markers_per_frame()},
                               {"rounds", rounds},
                               {"runmark_ms", ours.median()},
                               {"copy_ratio", ours.median() / median("copy")},
                               {"opencv_ratio", median("opencv-subpix") / ours.median()},
                               {"apriltag_ratio", median("apriltag-1") / ours.median()},
                               {"apriltag_decimate2_ratio", median("apriltag-2") / ours.median()},
                               {"p95_over_median", figures.spread.p95() / figures.spread.median()},
                               {"spread_frames", figures.spread.milliseconds.size()},
                               {"streaming_ratio", median("runmark-streamed") / ours.median()}};
  for (const Timing& t : timings) {
    entry["ms"][t.worker] = {{"median", t.median()}, {"p95", t.p95()}, {"worst", t.worst()}};
  }
  double sum = 0;
  for (const CoreTime& core : figures.cores) sum += core.milliseconds;
  for (const CoreTime& core : figures.cores) entry["core_shares"][core.core] = core.milliseconds / sum;
  const TimeModel model = fit_time(figures.work);
  entry["time_model_ns"] = {{"per_pixel", model.per_pixel},
                            {"per_crack_run", model.per_crack_run},
                            {"per_marker", model.per_marker},
                            {"relative_error", model.error}};
  for (const FrameWork& work : figures.work) {
    entry["work"].push_back({{"pixels", work.pixels},
                             {"crack_runs", work.crack_runs},
                             {"markers", work.markers},
                             {"ms", work.milliseconds}});
  }
  if (figures.noise) entry["noise"] = to_json(*figures.noise, ours.median());
  return entry;
}

}  // namespace runmark::bench
