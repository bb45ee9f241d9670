// Noise of every density and granularity through the cores, held to the naive follower.

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <vector>

#include "contour_checker.h"
#include "noise_image.h"
#include "pixel_limit.h"
#include "preprocess/crack_runs.h"
#include "runmark/options.h"

namespace runmark {
namespace {

constexpr std::uint32_t any = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t whole_pool = 65535;

struct Run {
  ChainLimits limits;
  std::size_t capacity;
};

/// Early dropping on and off, and pools far too small.
constexpr Run runs[] = {
    {{.max_turns = any, .max_records = any}, whole_pool},
    {{.max_turns = 30, .max_records = 4096, .drop_early = true}, whole_pool},
    {{.max_turns = 30, .max_records = 4096, .drop_early = false}, whole_pool},
    {{.max_turns = 8, .max_records = 50, .min_height = 5, .holes = false, .drop_early = true}, whole_pool},
    {{.max_turns = 8, .max_records = 50, .min_height = 5, .holes = false, .drop_early = false}, whole_pool},
    {{.max_turns = 30}, 300},
    {{.max_turns = 30, .drop_early = false}, 300},
    {{.max_turns = 30}, 7},
    {{.max_turns = 30}, 1},
    {{.max_turns = 30}, 0},
};

void check_noise(int width, int height, int density, int granularity) {
  SCOPED_TRACE(testing::Message() << width << "x" << height << ", density " << density << ", granularity "
                                  << granularity);
  const auto seed = static_cast<std::uint64_t>(width * 1000 + density * 17 + granularity);
  const PixelImage image = noise_image(width, height, density, granularity, seed);
  static ContourChecker checker;  // keeps its memory
  for (const std::uint8_t cases : {filter_none, filter_all}) {
    const char* fault = checker.take(image, cases);
    ASSERT_EQ(fault, nullptr) << fault;
    for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
      fault = checker.follow(connectivity);
      ASSERT_EQ(fault, nullptr) << fault;
      for (const Run& run : runs) {
        fault = checker.link(run.limits, run.capacity);
        ASSERT_EQ(fault, nullptr) << fault << ", capacity " << run.capacity;
        const LinkerCounts& counts = checker.counts();
        // Work: a run costs constant time and every vertical crack has at most one run at its upper end.
        ASSERT_LE(counts.runs, static_cast<std::uint64_t>((width + 1) * height));
        // Every chain begins with a run of its own and is closed or given up once.
        ASSERT_LE(counts.closed + counts.dropped_full, counts.runs);
        ASSERT_LE(counts.handed_on + counts.dropped_rule + counts.dropped_full, counts.runs);
      }
    }
  }
}

TEST(RandomImages, Small) {
  for (int density = 0; density <= 100; density += 5) {
    for (int granularity = 1; granularity <= 16; ++granularity) check_noise(64, 64, density, granularity);
  }
}

TEST(RandomImages, OddSizes) {
  for (int density = 0; density <= 100; density += 10) {
    for (const int granularity : {1, 2, 3, 5, 9, 16}) check_noise(333, 129, density, granularity);
  }
}

TEST(RandomImages, Middling) {
  for (int density = 0; density <= 100; density += shortened() ? 50 : 20) {
    for (const int granularity : {1, 2, 4, 7, 12, 16}) check_noise(512, 512, density, granularity);
  }
}

TEST(RandomImages, Large) {
  if (shortened()) return check_noise(1024, 1024, 40, 2);
  for (const int density : {0, 10, 50, 65, 90, 100}) {
    for (const int granularity : {1, 4, 16}) check_noise(1024, 1024, density, granularity);
  }
}

/// What a frame gave: every point of every contour in order, and the counts.
struct Frame {
  std::vector<int> points;
  LinkerCounts counts;
  friend bool operator==(const Frame& a, const Frame& b) {
    return a.points == b.points && a.counts.runs == b.counts.runs && a.counts.closed == b.counts.closed &&
           a.counts.handed_on == b.counts.handed_on && a.counts.dropped_full == b.counts.dropped_full &&
           a.counts.dropped_rule == b.counts.dropped_rule;
  }
};

/// Feeds the first `rows` rows.
Frame feed(ContourLinker& linker, const PixelImage& image, int rows) {
  BitImage bits;
  bits.pack(image, 0, image.width());
  std::vector<CrackRun> found(max_crack_runs(image.width()));
  Frame frame;
  for (int y = 0; y < rows; ++y) {
    const std::size_t count =
        find_crack_runs(bits.row(y - 1), bits.row(y), bits.width(), Connectivity::eight, found);
    linker.row(static_cast<std::uint16_t>(y), std::span<CrackRun>(found).first(count),
               [&](const ClosedChain& chain) {
                 chain.runs([&](int from, int to, int line) {
                   frame.points.insert(frame.points.end(), {from, to, line});
                 });
               });
  }
  frame.counts = linker.counts();
  return frame;
}

TEST(RandomImages, AFrameThatRanOutLeavesTheNextOneAsNew) {
  constexpr int side = 200;
  const PixelImage noise = noise_image(side, side, 50, 1, 1);
  const PixelImage next = noise_image(side, side, 30, 3, 2);
  for (const std::size_t capacity : {0U, 1U, 5U, 60U, 600U, 6000U}) {
    std::vector<Record> records(capacity);
    std::vector<ChainEnd> ends(max_chain_ends(side));
    std::vector<EndIndex> end_at(side + 1);
    ContourLinker fresh(records, ends, end_at, {});
    const Frame expected = feed(fresh, next, side + 1);

    ContourLinker used(records, ends, end_at, {});
    const Frame crowded = feed(used, noise, side + 1);
    if (capacity < 600) {
      EXPECT_GT(crowded.counts.dropped_full, 0U);
    }
    used.begin_frame();
    EXPECT_EQ(feed(used, next, side + 1), expected) << "after a full pool of " << capacity;

    used.begin_frame();
    feed(used, noise, side / 2);
    EXPECT_GT(used.open_ends(), 0U);
    used.abandon();
    EXPECT_EQ(used.open_ends(), 0U);
    EXPECT_EQ(used.pool().alive(), 0U);
    used.begin_frame();
    EXPECT_EQ(feed(used, next, side + 1), expected) << "after a frame given up, pool of " << capacity;

    used.begin_frame();
    feed(used, noise, side / 2);
    used.begin_frame();
    EXPECT_EQ(feed(used, next, side + 1), expected) << "after a frame cut short, pool of " << capacity;
  }
}

// The worst image there is for a follower of crack runs.
TEST(RandomImages, CheckerboardCostsOneRunAPixel) {
  constexpr int side = 256;
  PixelImage image(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) image.set(x, y, (x + y) % 2 == 0);
  }
  ContourChecker checker;
  for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
    ASSERT_EQ(checker.take(image, filter_none), nullptr);
    ASSERT_EQ(checker.follow(connectivity), nullptr);
    ASSERT_EQ(checker.link({.max_turns = any, .max_records = any}), nullptr);
    EXPECT_EQ(checker.counts().runs, static_cast<std::uint64_t>(side * side));
  }
}

}  // namespace
}  // namespace runmark
