// A frame gives the same markers every time, whatever came before it.

#include <algorithm>
#include <cstring>

#include "scenes.h"
#include "support/picture.h"

namespace runmark::test {
namespace {

bool same(const Marker& a, const Marker& b) {
  return a.dictionary == b.dictionary && a.id == b.id && a.hamming == b.hamming && a.row == b.row &&
         std::memcmp(&a.margin, &b.margin, sizeof a.margin) == 0 &&
         std::memcmp(a.corners.data(), b.corners.data(), sizeof a.corners) == 0;
}

class Repeated : public testing::TestWithParam<Pipeline> {};

TEST_P(Repeated, AThousandFramesGiveTheSame) {
  const render::RenderedFrame scene = scene_of("vga", 3);
  Picture picture(scene.width, scene.height, 0);
  std::ranges::copy(scene.grey, &picture.at(0, 0));
  // The paper's corners suit markers that stand nearly upright: one more, for all of them.
  draw_at(picture, dictionary("tag36h11"), 11, turned_square({500.5, 380.5}, 64, 1), false, 30, 230);
  Detector detector = make_detector({.pipeline = GetParam()}, scene.width, scene.height);
  const Detection first = detector.detect(picture.view());
  const std::vector<Marker> expected(first.begin(), first.end());
  ASSERT_GT(expected.size(), 0U);
  const std::vector<std::uint8_t> noise = binary_noise(scene.width, scene.height / 8);
  const FrameStats stats = detector.stats();
  for (int i = 0; i < 1000; ++i) {
    if (i % 50 == 7) {
      ASSERT_EQ(
          detector.detect(ImageView::grey(noise.data(), scene.width, scene.height / 8, scene.width)).status,
          Status::ok);
    }
    const Detection found = detector.detect(picture.view());
    ASSERT_EQ(found.markers.size(), expected.size()) << "frame " << i;
    for (std::size_t m = 0; m < expected.size(); ++m) {
      ASSERT_TRUE(same(found.markers[m], expected[m])) << "frame " << i << ", marker " << m;
    }
    ASSERT_EQ(detector.stats().crack_runs, stats.crack_runs);
    ASSERT_EQ(detector.stats().closed_chains, stats.closed_chains);
    ASSERT_EQ(detector.stats().quads, stats.quads);
  }
}

INSTANTIATE_TEST_SUITE_P(Pipelines, Repeated,
                         testing::Values(Pipeline::paper, Pipeline::hardware, Pipeline::standard));

}  // namespace
}  // namespace runmark::test
