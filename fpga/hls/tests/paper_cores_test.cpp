#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>

#include "frames.h"
#include "pipeline/found_markers.h"
#include "runmark/detector.h"

namespace runmark::hls_form {
namespace {

/// What stands round the cores: a source of pixels, and a memory that takes the grey levels and answers reads
/// of rows that are complete.
std::vector<Marker> markers_of(const rtl::Scene& scene, const Settings& settings,
                               const Dictionary& dictionary) {
  PixelStream pixels("pixels");
  GreyStream grey("grey");
  GreyStream answers("answers");
  ReadStream reads("reads");
  MarkerStream markers("markers");
  static std::uint64_t codes[max_codes];
  std::copy(dictionary.codes.begin(), dictionary.codes.end(), codes);

  const std::jthread camera([&] {
    for (const std::uint8_t level : scene.grey) pixels.write(level);
  });
  std::atomic<bool> done = false;
  const std::jthread memory([&] {
    std::vector<std::uint8_t> levels;
    levels.reserve(scene.grey.size());
    std::optional<std::uint32_t> asked;
    while (!done || levels.size() < scene.grey.size()) {
      bool moved = false;
      if (levels.size() < scene.grey.size() && !grey.empty()) {
        levels.push_back(grey.read());
        moved = true;
      }
      if (!asked && !reads.empty()) asked = reads.read();
      const std::size_t y = asked ? *asked >> 16 : 0;
      if (asked && (y + 1) * static_cast<std::size_t>(scene.width) <= levels.size()) {
        answers.write(levels[y * static_cast<std::size_t>(scene.width) + (*asked & 0xFFFF)]);
        asked.reset();
        moved = true;
      }
      if (!moved) std::this_thread::sleep_for(std::chrono::microseconds(20));
    }
  });
  const std::jthread cores([&] { paper_cores(settings, codes, pixels, grey, reads, answers, markers); });

  FoundMarkers found(1000);
  found.begin_frame({0, 0});
  for (Word first = markers.read(); first != frame_end; first = markers.read()) {
    const Word second = markers.read();
    const Word rest = markers.read();
    Marker marker;
    marker.id = static_cast<int>(field(rest, 0, 16));
    marker.hamming = static_cast<int>(field(rest, 16, 8));
    marker.inverted = field(rest, 24, 1) != 0;
    for (unsigned i = 0; i < 4; ++i) {
      const CrackPoint place = place_of(i < 2 ? first : second, i % 2);
      marker.corners[i] = {place.x - 0.5, place.y - 0.5};
    }
    if (found.has(marker.corners)) continue;
    EXPECT_TRUE(found.add(marker));
  }
  done = true;
  return {found.all().begin(), found.all().end()};
}

TEST(HlsPaperCores, FindWhatThePaperPipelineFinds) {
  const auto dictionary = builtin_dictionary("DICT_6X6_250");
  ASSERT_TRUE(dictionary);
  std::mt19937_64 random(85);
  std::size_t compared = 0;
  std::size_t shown = 0;
  for (int i = 0; i < 8; ++i) {
    const int width = i == 7 ? 640 : 230 + static_cast<int>(random() % 30);
    const int height = i == 7 ? 480 : 118 + static_cast<int>(random() % 20);
    const rtl::Scene scene = rtl::make_scene(*dictionary, width, height, random);
    Options options;
    options.pipeline = Pipeline::paper;
    options.max_width = max_width;
    options.max_height = max_height;
    options.inverted = i % 4 == 3;
    auto detector = Detector::create(options, {*dictionary});
    ASSERT_TRUE(detector) << detector.error();
    const Detection plain = detector->detect(ImageView::grey(scene.grey.data(), width, height, width));

    Settings settings;
    settings.width = width;
    settings.height = height;
    settings.level = options.fixed_threshold;
    settings.min_height = static_cast<unsigned>(options.min_marker_size / 2);
    settings.holes = options.inverted;
    settings.corner_offset = options.corner_offset;
    settings.min_area = static_cast<int>(2 * options.min_marker_size * options.min_marker_size);
    settings.max_area = 2 * width * height;
    settings.max_errors = std::min(dictionary->corrected_bits, (dictionary->distance - 1) / 2);
    settings.codes = static_cast<int>(dictionary->codes.size());
    const std::vector<Marker> found = markers_of(scene, settings, *dictionary);

    ASSERT_EQ(found.size(), plain.markers.size()) << "scene " << i;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].id, plain.markers[k].id) << "scene " << i;
      EXPECT_EQ(found[k].hamming, plain.markers[k].hamming) << "scene " << i;
      EXPECT_EQ(found[k].inverted, plain.markers[k].inverted) << "scene " << i;
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_EQ(found[k].corners[c].x, plain.markers[k].corners[c].x) << "scene " << i;
        EXPECT_EQ(found[k].corners[c].y, plain.markers[k].corners[c].y) << "scene " << i;
      }
    }
    compared += found.size();
    shown += static_cast<std::size_t>(scene.markers);
  }
  EXPECT_GT(compared, shown / 2) << "of " << shown;
}

}  // namespace
}  // namespace runmark::hls_form
