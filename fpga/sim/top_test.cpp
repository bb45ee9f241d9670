// The hardware with its buses finds what C++ finds, in both profiles.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "figures/scenes.h"
#include "noise_image.h"
#include "top_profiles.h"

namespace runmark::rtl {
namespace {

TYPED_TEST_SUITE(RtlTop, Profiles, ProfileName);

/// Frames one behind the other, so that results of one come while the next is being taken in.
TYPED_TEST(RtlTop, FindsWhatThePipelineFinds) {
  std::mt19937_64 random(81);
  std::size_t markers = 0;
  const std::array<Manners, 6> all_manners{{{100, 100, 2, 100, 100, 1},
                                            {60, 100, 30, 50, 100, 2},
                                            {100, 50, 10, 100, 30, 3},
                                            {90, 60, 200, 70, 60, 4},
                                            {100, 90, 1000, 100, 90, 5},
                                            {30, 30, 5, 30, 30, 6}}};
  for (std::size_t m = 0; m < all_manners.size(); ++m) {
    const int width = m == 0 ? 256 : 230 + static_cast<int>(random() % 40);
    Options options = this->options(width, 119 + static_cast<int>(random() % 8));
    options.inverted = m % 3 == 2;
    options.above_is_dark = m == 3;
    options.filter = m == 1 ? filter_none : m == 4 ? filter_lone_hole : filter_standard;
    options.connectivity = m == 4 ? Connectivity::four : Connectivity::standard;
    const bool rgb = m % 2 == 1;
    Station<typename TypeParam::Vga> station(
        all_manners[m], options, this->dictionary(), TypeParam::vga_records,
        RUNMARK_CONTROL_PATIENT | (m % 2 == 0 ? RUNMARK_CONTROL_READ_RESULTS : 0U) |
            (rgb ? RUNMARK_CONTROL_RGB : 0U));
    std::vector<Scene> scenes;
    for (int i = 0; i < 4; ++i) {
      Scene scene = make_scene(this->dictionary(), options.max_width, options.max_height, random);
      if (options.above_is_dark) {
        for (std::uint8_t& grey : scene.grey) grey = static_cast<std::uint8_t>(255 - grey);
      }
      scenes.push_back(scene);
      station.bench.send(video_of(scene, rgb));
    }
    for (unsigned i = 0; i < scenes.size(); ++i) {
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame) << "manners " << m;
      EXPECT_EQ(difference(*frame, station.plain(scenes[i])), "") << "manners " << m << " frame " << i;
      EXPECT_EQ(frame->end.id, i);
      EXPECT_FALSE(frame->end.malformed || frame->end.lost);
      markers += frame->markers.size();
    }
    EXPECT_EQ(station.count(RUNMARK_FRAMES), 4U);
    EXPECT_EQ(station.count(RUNMARK_BAD_LINES), 0U);
    EXPECT_EQ(station.count(RUNMARK_BUS_ERRORS), 0U);
  }
  EXPECT_GT(markers, 20U);
}

/// Pictures of `runmark render --set vga` as video that does not pause.
TYPED_TEST(RtlTop, FindsWhatThePipelineFindsInRenderedScenes) {
  Station<typename TypeParam::Vga> station({}, this->options(640, 480), this->dictionary(),
                                           TypeParam::vga_records, RUNMARK_CONTROL_PATIENT);
  std::vector<Scene> scenes;
  for (const int i : TypeParam::rendered) {
    scenes.push_back(rendered_scene("vga", this->dictionary(), i));
    station.bench.send(video_of(scenes.back()));
  }
  std::size_t markers = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto frame = station.next_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(difference(*frame, station.plain(scenes[i])), "") << "scene " << TypeParam::rendered[i];
    markers += frame->markers.size();
    const std::size_t pixels = scenes[i].grey.size();
    const bool thin = station.plain_stats().crack_runs * 100 < 5 * pixels;
    if (i + 1 == scenes.size() || !thin) continue;
    // From the beginning of a frame to that of the next; the first pixels only fill the threshold core.
    const auto& taken = station.bench.taken_at();
    const auto clocks = static_cast<double>(taken[(i + 1) * pixels + 8] - taken[i * pixels + 8]);
    EXPECT_LE(clocks, TypeParam::clocks_a_pixel * static_cast<double>(pixels))
        << "scene " << TypeParam::rendered[i];
  }
  EXPECT_GE(markers, TypeParam::rendered.size());
}

TYPED_TEST(RtlTop, FindsWhatThePipelineFindsInAFullHdScene) {
  const Scene scene = rendered_scene("fullhd", this->dictionary(), TypeParam::rendered_large);
  Station<typename TypeParam::Large> station({}, this->options(scene.width, scene.height), this->dictionary(),
                                             TypeParam::large_records, RUNMARK_CONTROL_PATIENT,
                                             std::size_t{1} << 25);
  station.bench.send(video_of(scene));
  const auto frame = station.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(difference(*frame, station.plain(scene)), "");
  EXPECT_GT(frame->markers.size(), 0U);
}

/// Every image of 4x4 pixels, and filtered of 4x3, side by side in large frames, light between them. The
/// dictionary is one that takes nearly every quad for a marker, so that all five cores have their say.
TYPED_TEST(RtlTop, IsThePipelineOnEveryTinyImage) {
  constexpr unsigned pitch = 5;
  constexpr unsigned columns = 638 / pitch;
  constexpr unsigned rows = 478 / pitch;
  Options options = this->options(640, 480);
  options.min_marker_size = 0;
  options.corner_offset = 2;
  std::size_t markers = 0;
  for (const bool filtered : {true, false}) {
    options.filter = filtered ? filter_all : filter_none;
    options.connectivity = filtered ? Connectivity::four : Connectivity::eight;
    const unsigned images = filtered ? 1U << 12 : 1U << 16;
    Station<typename TypeParam::Vga> station({}, options, this->lax(), TypeParam::vga_records,
                                             RUNMARK_CONTROL_PATIENT);
    for (unsigned first = 0; first < images; first += columns * rows) {
      Scene scene{640, 480, 0, std::vector<std::uint8_t>(640 * 480, 200)};
      for (unsigned image = first; image < std::min(images, first + columns * rows); ++image) {
        const unsigned left = 1 + (image - first) % columns * pitch;
        const unsigned top = 1 + (image - first) / columns * pitch;
        for (unsigned pixel = 0; pixel < 16; ++pixel) {
          if ((image >> pixel & 1) != 0) scene.grey[(top + pixel / 4) * 640 + left + pixel % 4] = 50;
        }
      }
      station.bench.send(video_of(scene));
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame);
      ASSERT_EQ(difference(*frame, station.plain(scene)), "")
          << "images from " << first << (filtered ? ", filtered" : "");
      EXPECT_FALSE(frame->end.dropped);
      markers += frame->markers.size();
    }
  }
  EXPECT_GT(markers, 1000U);
}

/// 10,000 small frames of noise of any density and granularity, some of them grey, one behind the other.
TYPED_TEST(RtlTop, IsThePipelineOnSmallFrames) {
  std::mt19937_64 random(89);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::size_t markers = 0;
  std::size_t quads = 0;
  for (int i = 0; i < 200; ++i) {
    Options options = this->options(TypeParam::least_width + below(30), 3 + below(40));
    options.min_marker_size = below(8);
    options.inverted = below(2) != 0;
    options.corner_offset = 1 + below(4);
    options.connectivity = below(2) != 0 ? Connectivity::four : Connectivity::eight;
    if (below(2) != 0) options.filter = static_cast<std::uint8_t>(below(64));
    Station<typename TypeParam::Vga> station(
        {below(3) == 0 ? 60 : 100, 100, 1 + below(20), 100, 100, random()}, options, this->lax(),
        TypeParam::vga_records, RUNMARK_CONTROL_PATIENT);
    std::vector<Scene> scenes;
    for (int k = 0; k < 50; ++k) {
      const PixelImage image =
          noise_image(options.max_width, options.max_height, 10 + below(81), 1 + below(12), random());
      Scene scene{options.max_width, options.max_height, 0, {}};
      const int noise = k % 2 == 0 ? 1 : 1 + below(120);
      for (int y = 0; y < scene.height; ++y) {
        for (int x = 0; x < scene.width; ++x) {
          scene.grey.push_back(static_cast<std::uint8_t>((image.dark(x, y) ? 40 : 150) + below(noise)));
        }
      }
      station.bench.send(video_of(scene));
      scenes.push_back(std::move(scene));
    }
    for (const Scene& scene : scenes) {
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame);
      ASSERT_EQ(difference(*frame, station.plain(scene)), "") << "round " << i;
      markers += frame->markers.size();
      quads += station.plain_stats().quads;
    }
  }
  EXPECT_GT(markers, 1000U);
  EXPECT_GT(quads, markers);
}

/// Small frames of noise and marker pieces with lists so small that they run out: the same chains are
/// dropped.
TYPED_TEST(RtlTop, RunsOutAsThePipelineDoes) {
  std::mt19937_64 random(84);
  int dropped = 0;
  int whole = 0;
  std::size_t markers = 0;
  Options options = this->options(124, 124);
  options.inverted = true;
  Station<typename TypeParam::Small> station({95, 80, 400, 100, 100, 7}, options, this->dictionary(),
                                             TypeParam::small_records, RUNMARK_CONTROL_PATIENT);
  for (int pair = 0; pair < 20; ++pair) {
    std::vector<Scene> scenes;
    for (int i = 0; i < 2; ++i) {
      Scene scene = make_scene(this->dictionary(), 124, 124, random);
      for (unsigned spots = static_cast<unsigned>(random() % 400); spots > 0; --spots) {
        const auto at = static_cast<std::ptrdiff_t>(random() % (120 * 124));
        for (int y = 0; y < 4; ++y) std::fill_n(scene.grey.begin() + at + y * 124, 3, std::uint8_t{20});
      }
      scenes.push_back(scene);
      station.bench.send(video_of(scene));
    }
    for (const Scene& scene : scenes) {
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame);
      ASSERT_EQ(difference(*frame, station.plain(scene)), "") << "pair " << pair;
      dropped += frame->end.dropped;
      whole += 1 - frame->end.dropped;
      markers += frame->markers.size();
    }
  }
  EXPECT_GT(dropped, 3);
  EXPECT_GT(whole, 3);
  EXPECT_GT(markers, 5U);
}

}  // namespace
}  // namespace runmark::rtl
