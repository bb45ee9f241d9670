#include "bench/speed/measure.h"

#include <gtest/gtest.h>

namespace runmark::bench {
namespace {

TEST(Measure, TimesEveryWorkerOnEveryFrame) {
  const auto set = standard_frames("vga", 2);
  ASSERT_TRUE(set) << set.error();
  EXPECT_EQ(set->name, "640x480");
  EXPECT_GT(set->markers_per_frame(), 0);
  const std::vector<Timing> timings = measure(*set, 2);
  EXPECT_EQ(timings.size(), 9U);
  for (const Timing& timing : timings) {
    EXPECT_EQ(timing.milliseconds.size(), 2U) << timing.worker;
    EXPECT_GT(timing.median(), 0) << timing.worker;
    EXPECT_LE(timing.median(), timing.worst()) << timing.worker;
  }
  EXPECT_LT(timing_of(timings, "copy").median(), timing_of(timings, "apriltag-1").median());
}

TEST(Measure, KnowsNoOtherSets) {
  EXPECT_EQ(standard_frames("huge", 1).error(), "huge: no such standard set");
}

}  // namespace
}  // namespace runmark::bench
