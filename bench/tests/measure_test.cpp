#include "bench/speed/measure.h"

#include <gtest/gtest.h>

#include "bench/speed/core_times.h"
#include "bench/speed/frames.h"
#include "bench/speed/noise_sweep.h"
#include "bench/speed/time_model.h"

namespace runmark::bench {
namespace {

TEST(Measure, TimesEveryWorkerOnEveryFrame) {
  const auto set = standard_frames("vga", 2);
  ASSERT_TRUE(set) << set.error();
  EXPECT_EQ(set->name, "640x480");
  EXPECT_GT(set->markers_per_frame(), 0);
  const std::vector<Timing> timings = measure(*set, 2);
  EXPECT_EQ(timings.size(), 10U);
  for (const Timing& timing : timings) {
    EXPECT_EQ(timing.milliseconds.size(), 2U) << timing.worker;
    EXPECT_GT(timing.median(), 0) << timing.worker;
    EXPECT_LE(timing.median(), timing.worst()) << timing.worker;
  }
  EXPECT_LT(timing_of(timings, "copy").median(), timing_of(timings, "apriltag-1").median());
}

TEST(Measure, TimesRunmarkAloneOnMoreScenes) {
  const auto timing = measure_alone("vga", 3, 1);
  ASSERT_TRUE(timing) << timing.error();
  EXPECT_EQ(timing->milliseconds.size(), 3U);
  EXPECT_GT(timing->milliseconds.front(), 0);
  EXPECT_EQ(measure_alone("huge", 1, 1).error(), "huge: no such standard set");
}

TEST(Measure, CoresAddUpToTheDetector) {
  const auto set = standard_frames("vga", 1);
  ASSERT_TRUE(set) << set.error();
  const std::vector<CoreTime> cores = core_times(set->frames[0], 5);
  ASSERT_EQ(cores.size(), 5U);
  double sum = 0;
  for (const CoreTime& core : cores) sum += core.milliseconds;
  EXPECT_GT(cores[0].milliseconds, 0) << "threshold";
  EXPECT_GT(sum, cores[0].milliseconds);
}

TEST(Measure, NoiseIsWorstInBetween) {
  const NoiseSweep sweep = sweep_noise(160, 120, 1);
  ASSERT_EQ(sweep.cells.size(), 55U);
  EXPECT_EQ(sweep.cells[0].crack_runs, 0U) << "all white";
  EXPECT_GT(sweep.cells[5].crack_runs, 5000U) << "half of the pixels black";
  EXPECT_GT(sweep.worst(), sweep.cells[0].milliseconds);
  EXPECT_GT(sweep.memory, 0U);
}

TEST(Measure, TimeModelFindsItsParts) {
  std::vector<FrameWork> frames;
  for (int i = 1; i <= 8; ++i) {
    const FrameWork work{1e5 * i, 700.0 * (i % 3), 1.0 * (i % 4), 0};
    frames.push_back(work);
    frames.back().milliseconds = (work.pixels * 0.2 + work.crack_runs * 9 + work.markers * 4000) / 1e6;
  }
  const TimeModel model = fit_time(frames);
  EXPECT_NEAR(model.per_pixel, 0.2, 1e-6);
  EXPECT_NEAR(model.per_crack_run, 9, 1e-4);
  EXPECT_NEAR(model.per_marker, 4000, 1e-2);
  EXPECT_NEAR(model.error, 0, 1e-6);
}

TEST(Measure, KnowsNoOtherSets) {
  EXPECT_EQ(standard_frames("huge", 1).error(), "huge: no such standard set");
}

}  // namespace
}  // namespace runmark::bench
