// A detector asks for no memory after it is made.

#include <algorithm>

#include "counted_new.h"
#include "scenes.h"

namespace runmark::test {
namespace {

class Allocations : public testing::TestWithParam<Pipeline> {};

TEST_P(Allocations, NoneForAWholeFrame) {
  const render::RenderedFrame scene = scene_of("vga", 0);
  const std::vector<std::uint8_t> noise = binary_noise(scene.width, scene.height);
  Detector detector = make_detector({.pipeline = GetParam()}, scene.width, scene.height);
  const std::uint64_t before = allocations();
  for (int round = 0; round < 3; ++round) {
    ASSERT_EQ(detector.detect(view_of(scene)).status, Status::ok);
    ASSERT_EQ(detector.detect(ImageView::grey(noise.data(), scene.width, scene.height, scene.width)).status,
              Status::ok);
  }
  EXPECT_EQ(allocations(), before);
}

TEST_P(Allocations, NoneForStreamedRows) {
  const render::RenderedFrame scene = scene_of("vga", 1);
  for (const bool copy : {false, true}) {
    Detector detector = make_detector({.pipeline = GetParam(), .copy_rows = copy}, scene.width, scene.height);
    const std::uint64_t before = allocations();
    for (int round = 0; round < 3; ++round) {
      ASSERT_EQ(detector.begin(scene.width, scene.height), Status::ok);
      for (int y = 0; y < scene.height; y += 7) {
        ASSERT_EQ(detector.push_rows(view_of(scene).rows(y, std::min(7, scene.height - y))), Status::ok);
      }
      ASSERT_EQ(detector.end(), Status::ok);
    }
    EXPECT_EQ(allocations(), before);
  }
}

TEST_P(Allocations, NoneForColour) {
  const render::RenderedFrame scene = scene_of("vga", 0);
  std::vector<std::uint8_t> bgr;
  for (const std::uint8_t grey : scene.grey) bgr.insert(bgr.end(), 3, grey);
  Detector detector = make_detector({.pipeline = GetParam()}, scene.width, scene.height);
  const std::uint64_t before = allocations();
  const std::ptrdiff_t stride = std::ptrdiff_t{3} * scene.width;
  ASSERT_EQ(detector.detect(ImageView::bgr(bgr.data(), scene.width, scene.height, stride)).status,
            Status::ok);
  EXPECT_EQ(allocations(), before);
}

TEST(CountedNew, Counts) {
  const std::uint64_t before = allocations();
  const Detector detector = make_detector({}, 64, 64);
  EXPECT_GT(allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Pipelines, Allocations,
                         testing::Values(Pipeline::paper, Pipeline::hardware, Pipeline::standard));

}  // namespace
}  // namespace runmark::test
