// How much memory a detector holds, and that it is all it says.

#include <malloc.h>

#include <cstdio>

#include "scenes.h"

namespace runmark::test {
namespace {

TEST(Memory, AtMostTwoMegabytesAtFullHd) {
#if defined(RUNMARK_SANITIZED)
  GTEST_SKIP() << "the sanitizer's allocator does not say what it holds";
#endif
  const auto before = mallinfo2().uordblks + mallinfo2().hblkhd;
  const Detector detector = make_detector({}, 1920, 1080);
  const auto held = mallinfo2().uordblks + mallinfo2().hblkhd - before;
  std::printf("  memory() %zu bytes, held by the allocator %zu\n", detector.memory(), held);
  EXPECT_LE(detector.memory(), 2'000'000U);
  EXPECT_LE(held, 2'000'000U);
  // What a detector says is what it holds, up to small blocks nobody counts (names, the objects themselves).
  EXPECT_NEAR(static_cast<double>(detector.memory()), static_cast<double>(held),
              0.1 * static_cast<double>(held));
}

TEST(Memory, DoesNotGrowWithFrames) {
  const render::RenderedFrame scene = scene_of("vga", 2);
  Detector detector = make_detector({}, scene.width, scene.height);
  const std::size_t memory = detector.memory();
  const auto before = mallinfo2().uordblks;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(detector.detect(view_of(scene)).status, Status::ok);
  EXPECT_EQ(detector.memory(), memory);
  EXPECT_EQ(mallinfo2().uordblks, before);
}

}  // namespace
}  // namespace runmark::test
