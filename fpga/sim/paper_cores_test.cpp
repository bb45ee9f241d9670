#include <gtest/gtest.h>

#include "paper_bench.h"

namespace runmark::rtl {
namespace {

constexpr const char* dictionary_name = "DICT_6X6_250";

void expect_same(const Outcome& hardware, const Detection& plain, const char* what) {
  ASSERT_TRUE(hardware.ended) << what;
  EXPECT_EQ(hardware.dropped, 0U) << what;
  EXPECT_FALSE(hardware.grey_differs) << what;
  EXPECT_FALSE(hardware.list_full) << what;
  ASSERT_EQ(hardware.markers.size(), plain.markers.size()) << what;
  for (std::size_t i = 0; i < plain.markers.size(); ++i) {
    const Marker& a = hardware.markers[i];
    const Marker& b = plain.markers[i];
    EXPECT_EQ(a.id, b.id) << what;
    EXPECT_EQ(a.hamming, b.hamming) << what;
    EXPECT_EQ(a.inverted, b.inverted) << what;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(a.corners[k].x, b.corners[k].x) << what;
      EXPECT_EQ(a.corners[k].y, b.corners[k].y) << what;
    }
  }
}

TEST(RtlPaperCores, FindWhatThePaperPipelineFinds) {
  auto dictionary = builtin_dictionary(dictionary_name);
  ASSERT_TRUE(dictionary);
  const int max_errors = std::min(dictionary->corrected_bits, (dictionary->distance - 1) / 2);
  PaperBench bench(*dictionary);
  std::mt19937_64 random(61);
  int markers = 0;
  int shown = 0;
  const int scenes = 16;
  std::uint64_t latest = 0;
  for (int i = 0; i < scenes; ++i) {
    const bool vga = i >= scenes - 2;
    const int width = vga ? 640 : 230 + static_cast<int>(random() % 30);
    const int height = vga ? 480 : 118 + static_cast<int>(random() % 20);
    const Scene scene = make_scene(*dictionary, width, height, random);
    Options options;
    options.pipeline = Pipeline::paper;
    options.max_width = 640;
    options.max_height = 480;
    options.inverted = i % 4 == 3;
    auto detector = Detector::create(options, {*dictionary});
    ASSERT_TRUE(detector) << detector.error();
    const Detection plain = detector->detect(ImageView::grey(scene.grey.data(), width, height, width));
    ASSERT_EQ(plain.status, Status::ok);
    const Outcome hardware =
        bench.run(scene, options, max_errors, i % 2 == 0 ? 100 : 70, i % 3 == 0 ? 0 : 40);
    expect_same(hardware, plain, ("scene " + std::to_string(i)).c_str());
    EXPECT_EQ(hardware.quads, detector->stats().quads) << "scene " << i;
    markers += static_cast<int>(plain.markers.size());
    shown += scene.markers;
    if (vga && i % 2 == 0) {
      EXPECT_LE(static_cast<double>(hardware.cycles) / (width * height), 1.05);
      latest = hardware.latest;
    }
  }
  EXPECT_GT(markers, shown / 2) << "of " << shown;
  RecordProperty("latency_clocks", static_cast<int>(latest));
  std::printf("%d of %d markers; longest wait for a report %d clocks after a marker's last pixel\n", markers,
              shown, static_cast<int>(latest));
}

}  // namespace
}  // namespace runmark::rtl
