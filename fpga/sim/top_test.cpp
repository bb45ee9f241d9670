#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "Vrunmark_top.h"
#include "Vrunmark_top_4k.h"
#include "Vrunmark_top_small.h"
#include "render/recipe.h"
#include "render/standard_sets.h"
#include "top_frames.h"

namespace runmark::rtl {
namespace {

constexpr std::size_t vga_records = 1023;
constexpr std::size_t small_records = 40;

using VgaBench = TopBench<Vrunmark_top>;
/// So small that everything runs out: 128x128, 40 records, 8 events, 2 chains.
using SmallBench = TopBench<Vrunmark_top_small>;

const Dictionary& dictionary() {
  static const Dictionary it = *builtin_dictionary("DICT_6X6_250");
  return it;
}

const Dictionary& lax() {
  static const Dictionary it = made_lax(dictionary());
  return it;
}

Options paper_options(int width, int height) {
  Options options;
  options.pipeline = Pipeline::paper;
  options.max_width = width;
  options.max_height = height;
  return options;
}

/// The bench, its processor's program and the C++ pipeline with the same settings.
template <class Bench>
class Station {
 public:
  Station(const Manners& manners, const Options& options, const Dictionary& codes, std::size_t records,
          std::uint32_t control, std::size_t memory_bytes = std::size_t{1} << 20)
      : bench(manners, memory_bytes),
        height_(options.max_height),
        filtered_(or_own(options.filter, filter_all) != 0),
        by_register_((control & RUNMARK_CONTROL_READ_RESULTS) != 0),
        reference_(options, codes, records) {
    const runmark_settings settings =
        settings_of(options, codes, options.max_width, options.max_height, control);
    EXPECT_EQ(runmark_configure(&bench.device(), &settings), RUNMARK_OK);
    EXPECT_EQ(
        runmark_load_codes(&bench.device(), codes.codes.data(), static_cast<unsigned>(codes.codes.size())),
        RUNMARK_OK);
    runmark_run(&bench.device(), 1);
  }
  ~Station() { EXPECT_EQ(bench.faults(), std::vector<std::string>{}); }
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Runs the clock until a frame has ended.
  std::optional<FrameOutcome> next_frame() {
    for (const std::uint64_t until = bench.cycles() + 5000000; bench.cycles() < until;) {
      runmark_record record{};
      if (!next_record(record)) continue;
      if (auto outcome = collector_.add(record, height_, filtered_)) return outcome;
    }
    ADD_FAILURE() << "no frame ended";
    return {};
  }

  FrameOutcome plain(const Scene& scene) { return reference_.run(scene); }
  [[nodiscard]] const FrameStats& plain_stats() const { return reference_.stats(); }
  std::uint32_t count(std::uint32_t at) { return bench.read_register(at); }

  Bench bench;

 private:
  bool next_record(runmark_record& record) {
    if (by_register_) return runmark_next_result(&bench.device(), &record) != 0;
    bench.tick();
    const auto taken = bench.take_record();
    if (taken) record = taken->record;
    return taken.has_value();
  }

  int height_;
  bool filtered_;
  bool by_register_;
  PaperReference reference_;
  FrameCollector collector_;
};

/// Frames one behind the other, so that results of one come while the next is being taken in.
TEST(RtlTop, FindsWhatThePaperPipelineFinds) {
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
    Options options = paper_options(width, 119 + static_cast<int>(random() % 8));
    options.inverted = m % 3 == 2;
    options.above_is_dark = m == 3;
    options.filter = m == 1 ? filter_none : m == 4 ? filter_lone_hole : filter_standard;
    options.connectivity = m == 4 ? Connectivity::four : Connectivity::standard;
    const bool rgb = m % 2 == 1;
    Station<VgaBench> station(all_manners[m], options, dictionary(), vga_records,
                              RUNMARK_CONTROL_PATIENT | (m % 2 == 0 ? RUNMARK_CONTROL_READ_RESULTS : 0U) |
                                  (rgb ? RUNMARK_CONTROL_RGB : 0U));
    std::vector<Scene> scenes;
    for (int i = 0; i < 4; ++i) {
      Scene scene = make_scene(dictionary(), options.max_width, options.max_height, random);
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

/// Pictures of `runmark render --set vga`, at one pixel a clock: some of those with markers upright enough
/// for the paper's cores.
TEST(RtlTop, FindsWhatThePaperPipelineFindsInRenderedScenes) {
  const render::StandardSet* set = render::find_standard_set("vga");
  ASSERT_NE(set, nullptr);
  const Options options = paper_options(640, 480);
  Station<VgaBench> station({}, options, dictionary(), vga_records, RUNMARK_CONTROL_PATIENT);
  std::size_t markers = 0;
  for (const int i : {21, 33, 62, 81, 106}) {
    const render::RenderedFrame picture =
        render::render(render::make_scene(set->recipe, dictionary(), render::set_seed("vga", 0), i));
    const Scene scene{picture.width, picture.height, 0, picture.grey};
    const std::uint64_t begin = station.bench.cycles();
    station.bench.send(video_of(scene));
    const auto frame = station.next_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(difference(*frame, station.plain(scene)), "") << "scene " << i;
    if (station.plain_stats().crack_runs * 100 < 5 * scene.grey.size()) {
      EXPECT_LT(static_cast<double>(station.bench.cycles() - begin), 1.03 * 640 * 480) << "scene " << i;
    }
    markers += frame->markers.size();
  }
  EXPECT_GE(markers, 5U);
}

TEST(RtlTop, FindsWhatThePaperPipelineFindsInAFullHdScene) {
  const render::StandardSet* set = render::find_standard_set("fullhd");
  ASSERT_NE(set, nullptr);
  const render::RenderedFrame picture =
      render::render(render::make_scene(set->recipe, dictionary(), render::set_seed("fullhd", 0), 12));
  const Scene scene{picture.width, picture.height, 0, picture.grey};
  Station<TopBench<Vrunmark_top_4k>> station({}, paper_options(scene.width, scene.height), dictionary(), 4095,
                                             RUNMARK_CONTROL_PATIENT, std::size_t{1} << 25);
  station.bench.send(video_of(scene));
  const auto frame = station.next_frame();
  ASSERT_TRUE(frame);
  EXPECT_EQ(difference(*frame, station.plain(scene)), "");
  EXPECT_GT(frame->markers.size(), 0U);
}

/// Every image of 4x4 pixels, and filtered of 4x3, side by side in large frames, light between them. The
/// dictionary is one that takes nearly every quad for a marker, so that all five cores have their say.
TEST(RtlTop, IsThePaperPipelineOnEveryTinyImage) {
  constexpr unsigned pitch = 5;
  constexpr unsigned columns = 638 / pitch;
  constexpr unsigned rows = 478 / pitch;
  Options options = paper_options(640, 480);
  options.min_marker_size = 0;
  options.corner_offset = 2;
  std::size_t markers = 0;
  for (const bool filtered : {true, false}) {
    options.filter = filtered ? filter_all : filter_none;
    options.connectivity = filtered ? Connectivity::four : Connectivity::eight;
    const unsigned images = filtered ? 1U << 12 : 1U << 16;
    Station<VgaBench> station({}, options, lax(), vga_records, RUNMARK_CONTROL_PATIENT);
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

/// Small frames of noise and marker pieces with lists so small that they run out: the same chains are
/// dropped.
TEST(RtlTop, RunsOutAsThePaperPipelineDoes) {
  std::mt19937_64 random(84);
  int dropped = 0;
  int whole = 0;
  std::size_t markers = 0;
  Options options = paper_options(124, 124);
  options.inverted = true;
  Station<SmallBench> station({95, 80, 400, 100, 100, 7}, options, dictionary(), small_records,
                              RUNMARK_CONTROL_PATIENT);
  for (int pair = 0; pair < 20; ++pair) {
    std::vector<Scene> scenes;
    for (int i = 0; i < 2; ++i) {
      Scene scene = make_scene(dictionary(), 124, 124, random);
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

/// One way of being malformed. Every frame of it ends, is flagged, and leaves the next one right.
struct Damage {
  const char* name;
  std::uint32_t counter;  ///< the register that must count it
  void (*apply)(std::vector<VideoBeat>& beats, std::mt19937_64& random);
};
constexpr int bad_width = 231;
constexpr int bad_height = 119;
const std::array damages{
    Damage{"cut off anywhere", RUNMARK_CUT_FRAMES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             beats.resize(1 + random() % ((bad_height - 1) * bad_width));
           }},
    Damage{"cut off after a line", RUNMARK_CUT_FRAMES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             beats.resize((1 + random() % (bad_height - 1)) * bad_width);
           }},
    Damage{"short lines", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             for (int n = 0; n < 5; ++n) {
               const auto line = static_cast<std::ptrdiff_t>(random() % (bad_height - 6)) * bad_width;
               beats[static_cast<std::size_t>(line) + 20].last = true;
               beats.erase(beats.begin() + line + 21, beats.begin() + line + bad_width);
             }
           }},
    Damage{"lines of one pixel", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64&) {
             for (VideoBeat& beat : beats) beat.last = true;
           }},
    Damage{"long lines", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             for (int n = 0; n < 5; ++n) {
               const auto line = static_cast<std::ptrdiff_t>(random() % bad_height) * bad_width;
               beats.insert(beats.begin() + line + 9, 7, {});
             }
           }},
    Damage{"a line's end is missing", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             beats[(1 + random() % bad_height) * bad_width - 1].last = false;
           }},
    Damage{"no line ends at all", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64&) {
             for (VideoBeat& beat : beats) beat.last = false;
           }},
    Damage{"a start of frame on every line", RUNMARK_CUT_FRAMES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64&) {
             for (std::size_t i = 0; i < 6 * bad_width; i += bad_width) beats[i].user = true;
             beats.resize(6 * bad_width);
           }},
};

TEST(RtlTop, IsRightAgainAfterMalformedVideo) {
  std::mt19937_64 random(82);
  const Options options = paper_options(bad_width, bad_height);
  std::size_t markers = 0;
  Station<VgaBench> station({95, 80, 20, 100, 100, 8}, options, dictionary(), vga_records,
                            RUNMARK_CONTROL_READ_RESULTS | RUNMARK_CONTROL_PATIENT);
  for (int round = 0; round < 3; ++round) {
    for (const Damage& damage : damages) {
      std::vector<VideoBeat> beats = video_of(make_scene(dictionary(), bad_width, bad_height, random));
      damage.apply(beats, random);
      const auto starts =
          std::count_if(beats.begin(), beats.end(), [](const VideoBeat& b) { return b.user; });
      const std::uint32_t before = station.count(damage.counter);
      station.bench.send(beats);
      const Scene good = make_scene(dictionary(), bad_width, bad_height, random);
      station.bench.send(video_of(good));
      for (std::ptrdiff_t i = 0; i < starts; ++i) {
        const auto bad = station.next_frame();
        ASSERT_TRUE(bad) << damage.name;
        EXPECT_TRUE(bad->end.malformed) << damage.name;
      }
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame) << damage.name;
      EXPECT_EQ(difference(*frame, station.plain(good)), "") << "after: " << damage.name;
      EXPECT_FALSE(frame->end.malformed) << "after: " << damage.name;
      EXPECT_GT(station.count(damage.counter), before) << damage.name;
      markers += frame->markers.size();
    }
  }
  EXPECT_GT(markers, 20U);
}

/// Too many lines are dropped without a word: between two frames everything is.
TEST(RtlTop, DropsWhatIsBelowTheLastLine) {
  std::mt19937_64 random(85);
  const Options options = paper_options(200, 118);
  Station<VgaBench> station({}, options, dictionary(), vga_records, RUNMARK_CONTROL_PATIENT);
  for (int i = 0; i < 2; ++i) {
    const Scene scene = make_scene(dictionary(), 200, 118, random);
    std::vector<VideoBeat> beats = video_of(scene);
    beats.insert(beats.end(), beats.begin() + 1, beats.begin() + 5 * 200);
    station.bench.send(beats);
    const auto frame = station.next_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(difference(*frame, station.plain(scene)), "");
    EXPECT_FALSE(frame->end.malformed);
  }
}

/// Nobody takes results for a while, nobody answers the memory, chains come faster than they are walked
/// along: what is lost is counted and flagged, nothing stands still, and a good frame later on is right.
TEST(RtlTop, IsRightAgainAfterItsQueuesWereFull) {
  std::mt19937_64 random(86);
  Options options = paper_options(120, 120);
  options.min_marker_size = 2;
  std::uint32_t lost = 0;
  for (const std::uint32_t give_up : {0U, RUNMARK_CONTROL_GIVE_UP}) {
    Station<SmallBench> station({100, 60, 200, 100, 100, 9}, options, lax(), small_records, give_up);
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

TEST(RtlTop, CountsWhatTheMemoryRefuses) {
  std::mt19937_64 random(87);
  const Options options = paper_options(230, 120);
  Station<VgaBench> station({}, options, dictionary(), vga_records, RUNMARK_CONTROL_PATIENT);
  const Scene scene = make_scene(dictionary(), 230, 120, random);
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
