// The bounds of memory and work that docs/reliability.md states, on pictures made to break them.

#include <time.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "counted_new.h"
#include "scenes.h"
#include "worst_cases.h"

namespace runmark::test {
namespace {

constexpr std::array pipelines{std::pair(Pipeline::standard, "default"), std::pair(Pipeline::paper, "paper"),
                               std::pair(Pipeline::hardware, "hardware")};

/// docs/reliability.md, memory.
std::size_t memory_bound(int width, int height, bool copy_rows) {
  constexpr std::size_t fixed = 1'000'000;
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  return fixed + 160 * columns + 8 * rows + (copy_rows ? columns * rows : 0);
}

TEST(Bounds, Memory) {
  std::size_t at_full_hd = 0;
  for (const auto& [pipeline, name] : pipelines) {
    for (const int width : {16, 320, 640, 1920, 3840, 8192, 65535}) {
      for (const int height : {16, 1080, 65535}) {
        for (const bool copy : {false, true}) {
          if (copy && height == 65535) continue;  // that is the caller's frame once more
          const Detector detector =
              make_detector({.pipeline = pipeline, .octaves = 6, .copy_rows = copy}, width, height);
          EXPECT_LE(detector.memory(), memory_bound(width, height, copy))
              << name << ' ' << width << 'x' << height;
          if (width == 1920 && height == 1080 && !copy) at_full_hd = std::max(at_full_hd, detector.memory());
        }
      }
    }
  }
  std::printf("  at 1920x1080, six halvings, tag36h11: %zu bytes at most, bound %zu\n", at_full_hd,
              memory_bound(1920, 1080, false));
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Work that is counted: no picture can make more of it.
void expect_work_bounded(const FrameStats& stats, int width, int height, const std::string& what) {
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  const auto rows = static_cast<std::uint64_t>(height);
  EXPECT_LE(3 * stats.pixels, 4 * pixels) << what;
  EXPECT_LE(stats.crack_runs, stats.pixels + 2 * rows) << what;
  EXPECT_LE(2 * stats.closed_chains, stats.crack_runs) << what;
  // An outline of at least 8 pixels across turns round 16 horizontal cracks, and there are no more than
  // pixels.
  EXPECT_LE(16 * stats.quads, stats.pixels) << what;
  EXPECT_LE(stats.records_peak, 7 * 65535U) << what;
}

struct Size {
  int width;
  int height;
};

class WorstCases : public testing::TestWithParam<int> {};

TEST_P(WorstCases, WorkAndMemory) {
  // docs/reliability.md, work: several times what a common processor needs, so that a busy machine passes.
  constexpr double most_nanoseconds = 400;
#if defined(RUNMARK_SANITIZED)
  constexpr double slowness = 20;
  constexpr std::array<Size, 2> sizes{{{64, 48}, {640, 480}}};
#else
  constexpr double slowness = 1;
  constexpr std::array<Size, 4> sizes{{{64, 48}, {640, 480}, {1920, 1080}, {3840, 2160}}};
#endif
  const WorstCase worst = worst_cases()[static_cast<std::size_t>(GetParam())];
  std::array<double, pipelines.size()> slowest{};
  for (const auto& [width, height] : sizes) {
    const WorstPicture picture = picture_of(worst, width, height);
    for (std::size_t p = 0; p < pipelines.size(); ++p) {
      const auto& [pipeline, name] = pipelines[p];
      Detector detector = make_detector({.pipeline = pipeline, .inverted = true}, width, height);
      const std::size_t memory = detector.memory();
      const std::uint64_t before = allocations();
      const double start = thread_seconds();
      ASSERT_EQ(detector.detect(picture.view()).status, Status::ok);
      const double seconds = thread_seconds() - start;
      EXPECT_EQ(allocations(), before) << worst.name;
      EXPECT_EQ(detector.memory(), memory) << worst.name;
      expect_work_bounded(detector.stats(), width, height, worst.name + ", " + name);
      slowest[p] = std::max(slowest[p], 1e9 * seconds / (1.0 * width * height));
    }
  }
  for (std::size_t p = 0; p < pipelines.size(); ++p) {
    std::printf("  %-24s %-9s %6.1f ns a pixel at most\n", worst.name.c_str(), pipelines[p].second,
                slowest[p]);
    EXPECT_LE(slowest[p], most_nanoseconds * slowness) << worst.name << ", " << pipelines[p].second;
  }
}

INSTANTIATE_TEST_SUITE_P(Pictures, WorstCases, testing::Range(0, static_cast<int>(worst_cases().size())));

}  // namespace
}  // namespace runmark::test
