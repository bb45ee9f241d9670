#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "Vpaper_cores.h"
#include "clocked.h"
#include "marker_scene.h"
#include "pipeline/found_markers.h"
#include "runmark/detector.h"

namespace runmark::rtl {
namespace {

constexpr const char* dictionary_name = "DICT_6X6_250";

struct Outcome {
  std::vector<Marker> markers;
  std::uint64_t cycles = 0;
  std::uint64_t latest = 0;  // clocks from the input of a marker's last row to its report, the longest
  std::uint64_t dropped = 0;
  std::uint64_t quads = 0;
  bool ended = false;
};

class Bench {
 public:
  explicit Bench(const Dictionary& dictionary) {
    core_->codes = static_cast<std::uint16_t>(dictionary.codes.size());
    for (std::size_t i = 0; i < dictionary.codes.size(); ++i) {
      core_->code_write = 1;
      drive(core_->code_at, i);
      core_->code = dictionary.codes[i];
      core_.tick();
    }
    core_->code_write = 0;
  }

  Outcome run(const Scene& scene, const Options& options, int max_errors, int percent_in, int latency) {
    drive(core_->last_x, static_cast<unsigned>(scene.width - 1));
    drive(core_->last_y, static_cast<unsigned>(scene.height - 1));
    drive(core_->level, static_cast<unsigned>(options.fixed_threshold));
    core_->above_is_dark = options.above_is_dark;
    core_->rgb = 0;
    core_->cases = filter_all;
    core_->eight = 1;
    core_->give_up = 0;
    core_->max_turns = 30;
    drive(core_->min_height, static_cast<unsigned>(options.min_marker_size / 2));
    core_->holes = options.inverted;
    core_->patient = 0;
    drive(core_->corner_offset, static_cast<unsigned>(options.corner_offset));
    drive(core_->min_area, static_cast<unsigned>(2 * options.min_marker_size * options.min_marker_size));
    drive(core_->max_area, (1U << 21) - 1);
    drive(core_->max_errors, static_cast<unsigned>(max_errors));

    Willing sends(percent_in, 51);
    Willing answers(latency == 0 ? 100 : 50, 52);
    struct Answer {
      std::uint8_t level;
      std::uint64_t due;
    };
    std::deque<Answer> due;
    Outcome result;
    FoundMarkers found(1000);
    found.begin_frame({0, 0});
    const std::uint64_t begin = core_.cycles();
    const int all = scene.width * scene.height;
    std::vector<std::uint64_t> row_at(static_cast<std::size_t>(scene.height));
    int at = 0;
    int grey_at = 0;
    bool offered = false;
    while (core_.cycles() - begin < static_cast<std::uint64_t>(all) * 10 && !result.ended) {
      offered = offered || (at < all && sends());
      core_->in_valid = offered;
      core_->in_sof = at == 0;
      core_->in_data = at < all ? scene.grey[static_cast<std::size_t>(at)] : 0;
      core_->grey_ready = 1;
      // A row can be read once all of it has come out.
      core_.settle();
      core_->read_ready =
          core_->read_valid && (static_cast<int>(core_->read_y) + 1) * scene.width <= grey_at && answers();
      core_->answer_valid = !due.empty() && due.front().due <= core_.cycles();
      if (core_->answer_valid) core_->answer = due.front().level;
      core_->marker_ready = answers();
      core_.settle();
      if (core_->answer_valid) due.pop_front();
      if (core_->in_valid && core_->in_ready) {
        if (at % scene.width == scene.width - 1)
          row_at[static_cast<std::size_t>(at / scene.width)] = core_.cycles();
        offered = false;
        ++at;
      }
      if (core_->grey_valid) {
        EXPECT_EQ(core_->grey_level, scene.grey[static_cast<std::size_t>(grey_at)]);
        ++grey_at;
      }
      if (core_->read_valid && core_->read_ready) {
        const std::size_t place =
            static_cast<std::size_t>(core_->read_y) * static_cast<std::size_t>(scene.width) + core_->read_x;
        due.push_back({scene.grey[place], core_.cycles() + 1 + static_cast<std::uint64_t>(latency)});
      }
      result.dropped += (core_->count_dropped_full | core_->count_dropped_queue | core_->lost) != 0 ? 1U : 0U;
      result.quads += core_->count_quad;
      if (core_->marker_valid && core_->marker_ready) {
        if (core_->marker_end) {
          result.ended = true;
        } else {
          add(found, core_.cycles(), row_at, result);
        }
      }
      core_.tick();
    }
    result.cycles = core_.cycles() - begin;
    result.markers.assign(found.all().begin(), found.all().end());
    return result;
  }

 private:
  void add(FoundMarkers& found, std::uint64_t now, const std::vector<std::uint64_t>& row_at,
           Outcome& result) {
    Marker marker;
    marker.id = core_->marker_id;
    marker.hamming = core_->marker_errors;
    marker.inverted = core_->marker_hole != 0;
    for (unsigned i = 0; i < 4; ++i) {
      marker.corners[i] = {static_cast<double>(core_->marker_x >> (10 * i) & 1023) - 0.5,
                           static_cast<double>(core_->marker_y >> (9 * i) & 511) - 0.5};
    }
    // The chain closed on this crack line: the last dark row is the one above.
    const std::size_t last = core_->marker_bottom - 1U;
    result.latest = std::max(result.latest, now - row_at[last]);
    if (found.has(marker.corners)) return;
    EXPECT_TRUE(found.add(marker));
  }
  Clocked<Vpaper_cores> core_;
};

void expect_same(const Outcome& hardware, const Detection& plain, const char* what) {
  ASSERT_TRUE(hardware.ended) << what;
  EXPECT_EQ(hardware.dropped, 0U) << what;
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
  Bench bench(*dictionary);
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
  std::printf("%d of %d markers; longest wait for a report %d clocks after a marker's last row\n", markers,
              shown, static_cast<int>(latest));
}

}  // namespace
}  // namespace runmark::rtl
