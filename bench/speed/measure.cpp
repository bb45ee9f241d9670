#include "bench/speed/measure.h"

#include <algorithm>

#include "bench/cpu_clock.h"
#include "bench/speed/median_time.h"
#include "bench/speed/workers.h"
#include "evaluate/percentile.h"

namespace runmark::bench {
namespace {

double time_of(const Worker& worker) {
  const double start = cpu_milliseconds();
  for (int i = 0; i < worker.repeats; ++i) worker.work();
  return (cpu_milliseconds() - start) / worker.repeats;
}

constexpr double quick = 20;  // milliseconds

}  // namespace

double Timing::median() const { return percentile(milliseconds, 0.5); }
double Timing::p95() const { return percentile(milliseconds, 0.95); }
double Timing::worst() const { return percentile(milliseconds, 1); }

std::vector<Timing> measure(const FrameSet& set, int rounds) {
  std::vector<Timing> timings;
  for (const TimedFrame& frame : set.frames) {
    const std::vector<Worker> workers = workers_for(frame);
    std::vector<std::vector<double>> times(workers.size());
    std::vector<double> last(workers.size(), 0);
    for (int round = 0; round <= rounds; ++round) {
      for (std::size_t i = 0; i < workers.size(); ++i) {
        // What the worker before it left in the caches would show in the times of quick ones.
        if (last[i] < quick) workers[i].work();
        const double taken = last[i] = time_of(workers[i]);
        if (round > 0) times[i].push_back(taken);
      }
    }
    if (timings.empty()) {
      for (const Worker& worker : workers) timings.push_back({worker.name, {}});
    }
    for (std::size_t i = 0; i < workers.size(); ++i) {
      std::ranges::sort(times[i]);
      timings[i].milliseconds.push_back(percentile(times[i], 0.5));
    }
  }
  for (Timing& timing : timings) std::ranges::sort(timing.milliseconds);
  return timings;
}

Result<Timing> measure_alone(const std::string& set, int scenes, int rounds) {
  Timing timing{"runmark", {}};
  for (int scene = 0; scene < scenes; ++scene) {
    const auto frames = standard_frames(set, 1, scene);
    if (!frames) return Error{frames.error()};
    timing.milliseconds.push_back(median_time(rounds, reader_for("runmark", frames->frames[0]).work));
  }
  std::ranges::sort(timing.milliseconds);
  return timing;
}

const Timing& timing_of(const std::vector<Timing>& timings, const std::string& worker) {
  return *std::ranges::find(timings, worker, &Timing::worker);
}

}  // namespace runmark::bench
