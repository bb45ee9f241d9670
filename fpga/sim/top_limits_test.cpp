// Queues that fill up, and a memory that refuses.
#include "top_profiles.h"

namespace runmark::rtl {
namespace {

template <class Profile>
class RtlTopLimits : public RtlTop<Profile> {};
TYPED_TEST_SUITE(RtlTopLimits, Profiles, ProfileName);

/// Nobody takes results for a while, nobody answers the memory, chains come faster than they are walked
/// along: what is lost is counted and flagged, nothing stands still, and a good frame later on is right.
TYPED_TEST(RtlTopLimits, IsRightAgainAfterItsQueuesWereFull) {
  std::mt19937_64 random(86);
  Options options = this->options(120, 120);
  options.min_marker_size = 2;
  std::uint32_t lost = 0;
  for (const std::uint32_t give_up : {0U, RUNMARK_CONTROL_GIVE_UP}) {
    Station<typename TypeParam::Small> station({100, 60, 200, 100, 100, 9}, options, this->lax(),
                                               TypeParam::small_records, give_up);
    for (int round = 0; round < 4; ++round) {
      Scene clutter{120, 120, 0, std::vector<std::uint8_t>(120 * 120, 200)};
      // Squares of a few pixels: chains that are handed on in quick succession, and quads.
      for (unsigned y = 4; y < 110; ++y) {
        for (unsigned x = 4; x < 112; ++x) {
          if (x % 12 < 8 && y % 12 < 8) clutter.grey[y * 120 + x] = 20;
        }
      }
      // Noise: more events than the contour core can take at one pixel a clock.
      for (unsigned i = 112 * 120; i < 117 * 120; ++i) {
        if (random() % 2 == 0) clutter.grey[i] = 20;
      }
      station.bench.hold_results(true);
      station.bench.send(video_of(clutter));
      for (int clock = 0; clock < 30000; ++clock) station.bench.tick();
      station.bench.hold_results(false);
      const auto bad = station.next_frame();
      ASSERT_TRUE(bad);
      EXPECT_TRUE(bad->end.dropped || bad->end.lost) << "round " << round;
      // A marker alone has few enough records, and nothing to give up.
      Scene good{120, 120, 0, std::vector<std::uint8_t>(120 * 120, 200)};
      for (unsigned y = 30; y < 70; ++y) std::fill_n(good.grey.begin() + y * 120 + 30, 40, 20);
      station.bench.send(video_of(good));
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame);
      EXPECT_EQ(difference(*frame, station.plain(good)), "") << "round " << round;
      EXPECT_FALSE(frame->end.dropped || frame->end.lost || frame->end.malformed);
    }
    const std::uint32_t dropped = station.count(RUNMARK_DROPPED_QUEUE) + station.count(RUNMARK_DROPPED_FULL);
    EXPECT_GT(dropped, 0U);
    lost += station.count(RUNMARK_LOST_FRAMES);
  }
  EXPECT_GT(lost, 0U);
}

TYPED_TEST(RtlTopLimits, CountsWhatTheMemoryRefuses) {
  std::mt19937_64 random(87);
  const Options options = this->options(230, 120);
  Station<typename TypeParam::Vga> station({}, options, this->dictionary(), TypeParam::vga_records,
                                           RUNMARK_CONTROL_PATIENT);
  const Scene scene = make_scene(this->dictionary(), 230, 120, random);
  station.bench.memory().fail(true);
  station.bench.send(video_of(scene));
  ASSERT_TRUE(station.next_frame());
  // Four bursts a row, and words that were read.
  EXPECT_GE(station.count(RUNMARK_BUS_ERRORS), 4U * 120);
  station.bench.memory().fail(false);
  station.bench.send(video_of(scene));
  const auto frame = station.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(difference(*frame, station.plain(scene)), "");
}

}  // namespace
}  // namespace runmark::rtl
