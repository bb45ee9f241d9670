#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "Vhardware_cores.h"
#include "clocked.h"
#include "pipeline/found_markers.h"
#include "pipeline/hardware_pipeline.h"
#include "render/recipe.h"
#include "render/standard_sets.h"
#include "runmark/detector.h"
#include "signed_port.h"

namespace runmark::rtl {
namespace {

constexpr const char* dictionary_name = "tag36h11";
constexpr unsigned coordinate_bits = 16;

struct Frame {
  int width = 0;
  int height = 0;
  int markers = 0;
  std::vector<std::uint8_t> grey;
};

struct Outcome {
  std::vector<Marker> markers;
  std::uint64_t cycles = 0;
  std::uint64_t latest = 0;  // clocks from the input of a marker's last row to its report, the longest
  std::uint64_t dropped = 0;
  std::uint64_t quads = 0;
  std::uint64_t runs = 0;
  unsigned record_peak = 0;
  bool ended = false;
};

class Bench {
 public:
  explicit Bench(const Dictionary& dictionary)
      : max_errors_(std::min(dictionary.corrected_bits, (dictionary.distance - 1) / 2)) {
    drive(core_->width, static_cast<unsigned>(dictionary.width));
    drive(core_->codes, dictionary.codes.size());
    for (std::size_t i = 0; i < dictionary.codes.size(); ++i) {
      core_->code_write = 1;
      drive(core_->code_at, i);
      core_->code = dictionary.codes[i];
      core_.tick();
    }
    core_->code_write = 0;
  }

  Outcome run(const Frame& frame, const Options& options, int percent_in, int latency) {
    set_registers(frame, options);
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
    const int all = frame.width * frame.height;
    std::vector<std::uint64_t> row_at(static_cast<std::size_t>(frame.height));
    int at = 0;
    int grey_at = 0;
    bool offered = false;
    while (core_.cycles() - begin < static_cast<std::uint64_t>(all) * 20 && !result.ended) {
      offered = offered || (at < all && sends());
      core_->in_valid = offered;
      core_->in_sof = at == 0;
      core_->in_data = at < all ? frame.grey[static_cast<std::size_t>(at)] : 0;
      core_->grey_ready = 1;
      // A row can be read once all of it has come out.
      core_.settle();
      core_->read_ready =
          core_->read_valid && (static_cast<int>(core_->read_y) + 1) * frame.width <= grey_at && answers();
      core_->answer_valid = !due.empty() && due.front().due <= core_.cycles();
      if (core_->answer_valid) core_->answer = due.front().level;
      core_->marker_ready = answers();
      core_.settle();
      if (core_->answer_valid) due.pop_front();
      if (core_->in_valid && core_->in_ready) {
        if (at % frame.width == frame.width - 1) {
          row_at[static_cast<std::size_t>(at / frame.width)] = core_.cycles();
        }
        offered = false;
        ++at;
      }
      if (core_->grey_valid) ++grey_at;
      if (core_->read_valid && core_->read_ready) {
        const std::size_t place =
            static_cast<std::size_t>(core_->read_y) * static_cast<std::size_t>(frame.width) + core_->read_x;
        due.push_back({frame.grey[place], core_.cycles() + 1 + static_cast<std::uint64_t>(latency)});
      }
      result.dropped += (core_->count_dropped_full | core_->count_dropped_queue | core_->lost) != 0 ? 1U : 0U;
      result.quads += core_->count_quad;
      result.runs += core_->count_run;
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
    result.record_peak = core_->record_peak;
    result.markers.assign(found.all().begin(), found.all().end());
    return result;
  }

 private:
  void set_registers(const Frame& frame, const Options& options) {
    const ContourRules rules = HardwarePipeline::contour_rules(options);
    const IntegerQuadLimits limits = HardwarePipeline::quad_limits(options);
    drive(core_->last_x, static_cast<unsigned>(frame.width - 1));
    drive(core_->last_y, static_cast<unsigned>(frame.height - 1));
    core_->rgb = 0;
    drive(core_->min_contrast, static_cast<unsigned>(options.min_contrast));
    core_->cases = rules.filter_cases;
    core_->eight = rules.connectivity == Connectivity::eight;
    core_->give_up = 0;
    drive(core_->max_turns, rules.chains.max_turns);
    drive(core_->min_height, rules.chains.min_height);
    core_->holes = rules.chains.holes;
    core_->patient = 0;
    drive(core_->min_area, static_cast<std::uint64_t>(limits.min_area));
    drive(core_->max_area, (std::uint64_t{1} << 20) - 1);
    drive(core_->min_side, static_cast<unsigned>(limits.min_side));
    drive(core_->min_margin, 13U);
    drive(core_->max_errors, static_cast<unsigned>(max_errors_));
  }

  void add(FoundMarkers& found, std::uint64_t now, const std::vector<std::uint64_t>& row_at,
           Outcome& result) {
    Marker marker;
    marker.id = core_->marker_id;
    marker.hamming = core_->marker_errors;
    marker.inverted = core_->marker_hole != 0;
    marker.margin = static_cast<float>(core_->marker_clearance) / static_cast<float>(core_->marker_scale);
    for (unsigned i = 0; i < 4; ++i) {
      marker.corners[i] = in_pixels({signed_part(core_->marker_x, i, coordinate_bits),
                                     signed_part(core_->marker_y, i, coordinate_bits)});
    }
    // The chain closed on this crack line: the last dark row is the one above.
    const std::size_t last = core_->marker_bottom - 1U;
    result.latest = std::max(result.latest, now - row_at[last]);
    if (found.has(marker.corners)) return;
    EXPECT_TRUE(found.add(marker));
  }

  int max_errors_;
  Clocked<Vhardware_cores> core_;
};

void expect_same(const Outcome& hardware, const Detection& plain, const std::string& what) {
  ASSERT_TRUE(hardware.ended) << what;
  EXPECT_EQ(hardware.dropped, 0U) << what;
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

Frame rendered(const Dictionary& dictionary, int scene) {
  const render::StandardSet* set = render::find_standard_set("vga");
  const render::RenderedFrame picture =
      render::render(render::make_scene(set->recipe, dictionary, render::set_seed("vga", 0), scene));
  return {picture.width,
          picture.height,
          static_cast<int>(picture.truth.markers.size()),
          {picture.grey.begin(), picture.grey.end()}};
}

/// The part of a frame from a pixel on.
Frame part_of(const Frame& frame, int left, int top, int width, int height) {
  Frame part{width, height, 0, {}};
  for (int y = top; y < top + height; ++y) {
    const auto begin = frame.grey.begin() + y * frame.width + left;
    part.grey.insert(part.grey.end(), begin, begin + width);
  }
  return part;
}

class RtlHardwareCores : public ::testing::Test {
 protected:
  RtlHardwareCores() : dictionary_(*builtin_dictionary(dictionary_name)), bench_(dictionary_) {}

  Outcome compare(const Frame& frame, Options options, int percent_in, int latency, const std::string& what) {
    options.pipeline = Pipeline::hardware;
    options.max_width = 640;
    options.max_height = 480;
    auto detector = Detector::create(options, {dictionary_});
    EXPECT_TRUE(detector) << detector.error();
    const Detection plain =
        detector->detect(ImageView::grey(frame.grey.data(), frame.width, frame.height, frame.width));
    EXPECT_EQ(plain.status, Status::ok);
    const Outcome hardware = bench_.run(frame, options, percent_in, latency);
    expect_same(hardware, plain, what);
    EXPECT_EQ(hardware.quads, detector->stats().quads) << what;
    EXPECT_EQ(hardware.runs, detector->stats().crack_runs) << what;
    return hardware;
  }

  Dictionary dictionary_;
  Bench bench_;
};

TEST_F(RtlHardwareCores, FindWhatTheHardwarePipelineFinds) {
  std::size_t markers = 0;
  int shown = 0;
  std::uint64_t latest = 0;
  for (const int scene : {1, 2, 6, 10}) {
    const Frame frame = rendered(dictionary_, scene);
    const Outcome hardware = compare(frame, {}, 100, 0, "scene " + std::to_string(scene));
    std::printf(
        "scene %d: %zu of %d markers, %.4f clocks a pixel, %u records, report %d clocks after the last row\n",
        scene, hardware.markers.size(), frame.markers,
        static_cast<double>(hardware.cycles) / (frame.width * frame.height), hardware.record_peak,
        static_cast<int>(hardware.latest));
    EXPECT_LE(static_cast<double>(hardware.cycles) / (frame.width * frame.height), 1.06);
    markers += hardware.markers.size();
    shown += frame.markers;
    latest = std::max(latest, hardware.latest);
  }
  EXPECT_GT(markers, static_cast<std::size_t>(shown / 2));
  RecordProperty("latency_clocks", static_cast<int>(latest));
}

TEST_F(RtlHardwareCores, AnyPaceAnySizeBothColours) {
  std::mt19937_64 random(61);
  const Frame whole = rendered(dictionary_, 10);
  std::size_t markers = 0;
  for (int i = 0; i < 12; ++i) {
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const int width = 150 + below(100);
    const int height = 120 + below(80);
    const Frame frame = part_of(whole, below(640 - width), below(480 - height), width, height);
    Options options;
    options.inverted = i % 4 == 3;
    if (i % 5 == 4) options.min_marker_size = 20;
    markers +=
        compare(frame, options, i % 2 == 0 ? 70 : 100, i % 3 == 0 ? 0 : 30, "part " + std::to_string(i))
            .markers.size();
  }
  EXPECT_GT(markers, 5U);
}

}  // namespace
}  // namespace runmark::rtl
