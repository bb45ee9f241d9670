// The five cores of each profile in a row, without buses: all that the pipeline in C++ finds, and as many
// candidates and runs.
#include <gtest/gtest.h>

#include "cores_bench.h"
#include "figures/scenes.h"

namespace runmark::rtl {
namespace {

void expect_same(const CoresOutcome& hardware, const Detection& plain, const std::string& what) {
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
    EXPECT_EQ(a.margin, b.margin) << what;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(a.corners[k].x, b.corners[k].x) << what;
      EXPECT_EQ(a.corners[k].y, b.corners[k].y) << what;
    }
  }
}

/// The cores and the pipeline on the same frames.
template <class Cores>
class Pair {
 public:
  explicit Pair(const char* dictionary) : dictionary_(*builtin_dictionary(dictionary)), bench_(dictionary_) {}

  [[nodiscard]] const Dictionary& dictionary() const { return dictionary_; }

  CoresOutcome compare(const Scene& scene, Options options, int percent_in, int latency,
                       const std::string& what) {
    options.pipeline = Cores::pipeline;
    options.max_width = 640;
    options.max_height = 480;
    auto detector = Detector::create(options, {dictionary_});
    EXPECT_TRUE(detector) << detector.error();
    const Detection plain =
        detector->detect(ImageView::grey(scene.grey.data(), scene.width, scene.height, scene.width));
    EXPECT_EQ(plain.status, Status::ok);
    const CoresOutcome hardware = bench_.run(scene, options, percent_in, latency);
    expect_same(hardware, plain, what);
    EXPECT_EQ(hardware.quads, detector->stats().quads) << what;
    EXPECT_EQ(hardware.runs, detector->stats().crack_runs) << what;
    return hardware;
  }

 private:
  Dictionary dictionary_;
  CoresBench<Cores> bench_;
};

double clocks_a_pixel(const CoresOutcome& hardware, const Scene& scene) {
  return static_cast<double>(hardware.cycles) / static_cast<double>(scene.grey.size());
}

TEST(RtlPaperCores, FindWhatThePaperPipelineFinds) {
  Pair<PaperCores> pair("DICT_6X6_250");
  std::mt19937_64 random(61);
  std::size_t markers = 0;
  int shown = 0;
  for (int i = 0; i < 16; ++i) {
    const bool vga = i >= 14;
    const int width = vga ? 640 : 230 + static_cast<int>(random() % 30);
    const int height = vga ? 480 : 118 + static_cast<int>(random() % 20);
    const Scene scene = make_scene(pair.dictionary(), width, height, random);
    Options options;
    options.inverted = i % 4 == 3;
    const CoresOutcome hardware = pair.compare(scene, options, i % 2 == 0 ? 100 : 70, i % 3 == 0 ? 0 : 40,
                                               "scene " + std::to_string(i));
    markers += hardware.markers.size();
    shown += scene.markers;
    if (vga && i % 2 == 0) {
      EXPECT_LE(clocks_a_pixel(hardware, scene), 1.05);
    }
  }
  EXPECT_GT(markers, static_cast<std::size_t>(shown / 2)) << "of " << shown;
}

TEST(RtlHardwareCores, FindWhatTheHardwarePipelineFinds) {
  Pair<HardwareCores> pair("tag36h11");
  std::size_t markers = 0;
  int shown = 0;
  for (const int i : {1, 2, 6, 10}) {
    const Scene scene = rendered_scene("vga", pair.dictionary(), i);
    const CoresOutcome hardware = pair.compare(scene, {}, 100, 0, "scene " + std::to_string(i));
    EXPECT_LE(clocks_a_pixel(hardware, scene), 1.06) << "scene " << i;
    markers += hardware.markers.size();
    shown += scene.markers;
  }
  EXPECT_GT(markers, static_cast<std::size_t>(shown / 2)) << "of " << shown;
}

/// The part of a scene from a pixel on.
Scene part_of(const Scene& scene, int left, int top, int width, int height) {
  Scene part{width, height, 0, {}};
  for (int y = top; y < top + height; ++y) {
    const auto begin = scene.grey.begin() + y * scene.width + left;
    part.grey.insert(part.grey.end(), begin, begin + width);
  }
  return part;
}

TEST(RtlHardwareCores, AnyPaceAnySizeBothColours) {
  Pair<HardwareCores> pair("tag36h11");
  std::mt19937_64 random(61);
  const Scene whole = rendered_scene("vga", pair.dictionary(), 10);
  std::size_t markers = 0;
  for (int i = 0; i < 12; ++i) {
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const int width = 150 + below(100);
    const int height = 120 + below(80);
    const Scene scene = part_of(whole, below(640 - width), below(480 - height), width, height);
    Options options;
    options.inverted = i % 4 == 3;
    if (i % 5 == 4) options.min_marker_size = 20;
    markers +=
        pair.compare(scene, options, i % 2 == 0 ? 70 : 100, i % 3 == 0 ? 0 : 30, "part " + std::to_string(i))
            .markers.size();
  }
  EXPECT_GT(markers, 5U);
}

}  // namespace
}  // namespace runmark::rtl
