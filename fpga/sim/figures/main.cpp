// Figures of the paper profile that only a simulation can give, as JSON for fpga/synth/report: cycles, record
// peaks, markers found with 1,023 records and without a limit, waiting times.
//   rtl_figures [--scenes N] [--upright N] [--check]
// Returns 1 when a scene misses a target. --check measures these scenes only.

#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "event_counts.h"
#include "match_clocks.h"
#include "paper_bench.h"
#include "scenes.h"

namespace runmark::rtl {
namespace {

using Json = nlohmann::json;

constexpr int memory_latency = 30;
constexpr const char* dictionary_name = "DICT_6X6_250";

Options paper_options(int width, int height) {
  Options options;
  options.pipeline = Pipeline::paper;
  options.max_width = width;
  options.max_height = height;
  return options;
}

bool same_marker(const Marker& a, const Marker& b) {
  const auto same = [](Point p, Point q) { return p.x == q.x && p.y == q.y; };
  return a.id == b.id && std::equal(a.corners.begin(), a.corners.end(), b.corners.begin(), same);
}

/// The frame through the hardware, with 1,023 records, and through the plain pipeline, with 65,535.
class Measure {
 public:
  explicit Measure(const Dictionary& dictionary)
      : bench_(dictionary),
        max_errors_(std::min(dictionary.corrected_bits, (dictionary.distance - 1) / 2)),
        detector_(Detector::create(paper_options(640, 480), {dictionary})) {}

  Json operator()(const Scene& scene, const std::string& name) {
    const Options options = paper_options(640, 480);
    const Detection plain =
        detector_->detect(ImageView::grey(scene.grey.data(), scene.width, scene.height, scene.width));
    const FrameStats& stats = detector_->stats();
    const Outcome hardware = bench_.run(scene, options, max_errors_, 100, memory_latency);
    const EventCounts events = count_events(scene, {options.fixed_threshold, options.above_is_dark});
    std::size_t missed = 0;
    for (const Marker& marker : plain) {
      const auto same = [&](const Marker& other) { return same_marker(marker, other); };
      missed += std::none_of(hardware.markers.begin(), hardware.markers.end(), same) ? 1U : 0U;
    }
    const auto pixels = static_cast<std::uint64_t>(scene.grey.size());
    return {
        {"name", name},
        {"pixels", pixels},
        {"width", scene.width},
        {"runs", events.runs()},
        {"segments", events.starts},
        {"events", events.all()},
        {"events_per_100_pixels", 100.0 * static_cast<double>(events.all()) / static_cast<double>(pixels)},
        {"contour_clocks", events.clocks(stats.closed_chains)},
        {"ended", hardware.ended},
        {"cycles", hardware.cycles},
        {"cycles_per_pixel", static_cast<double>(hardware.cycles) / static_cast<double>(pixels)},
        {"markers", plain.markers.size()},
        {"missed", missed},
        {"quads", stats.quads},
        {"quads_of_hardware", hardware.quads},
        {"dropped", hardware.dropped},
        {"record_peak", hardware.record_peak},
        {"record_peak_unlimited", stats.records_peak},
        {"end_peak", hardware.end_peak},
        {"latest_report", hardware.latest}};
  }

 private:
  PaperBench bench_;
  int max_errors_;
  Result<Detector> detector_;
};

/// Record peaks of the plain pipeline in rendered scenes of other sizes.
Json growth(const Dictionary& dictionary) {
  struct Size {
    const char* set;
    int width, height, scenes;
  };
  Json list = Json::array();
  for (const Size& size : {Size{"vga", 320, 240, 40},
                           {"vga", 640, 480, 40},
                           {"hd", 1280, 720, 24},
                           {"fullhd", 1920, 1080, 16},
                           {"uhd", 3840, 2160, 4}}) {
    auto detector = Detector::create(paper_options(size.width, size.height), {dictionary});
    std::uint64_t peak = 0;
    std::uint64_t runs = 0;
    for (int i = 0; i < size.scenes; ++i) {
      const Scene scene = rendered_scene(size.set, dictionary, i, size.width, size.height);
      (void)detector->detect(ImageView::grey(scene.grey.data(), size.width, size.height, size.width));
      peak = std::max(peak, detector->stats().records_peak);
      runs = std::max(runs, detector->stats().crack_runs);
    }
    list.push_back({{"width", size.width},
                    {"height", size.height},
                    {"scenes", size.scenes},
                    {"record_peak", peak},
                    {"most_runs", runs}});
  }
  return list;
}

/// Says what misses a target of the paper profile.
int misses(const Json& scenes) {
  int count = 0;
  const auto miss = [&](const Json& scene, const std::string& what) {
    std::cerr << "rtl_figures: " << scene["name"].get<std::string>() << ": " << what << '\n';
    ++count;
  };
  for (const Json& scene : scenes) {
    if (!scene["ended"]) miss(scene, "the frame does not end");
    if (scene["missed"] != 0) miss(scene, scene["missed"].dump() + " markers missed with 1023 records");
    if (scene["events_per_100_pixels"] < 10 && scene["cycles_per_pixel"] > 1.02) {
      miss(scene, scene["cycles_per_pixel"].dump() + " cycles a pixel");
    }
  }
  return count;
}

int run(int rendered, int upright, bool check) {
  const auto dictionary = builtin_dictionary(dictionary_name);
  if (!dictionary) return 2;
  Json figures{{"memory_latency", memory_latency}, {"dictionary", dictionary_name}};
  if (!check) {
    for (const unsigned codes : {1U, 50U, 250U, 1000U}) {
      figures["match"].push_back({{"codes", codes}, {"clocks", match_clocks(codes, memory_latency)}});
    }
    figures["growth"] = growth(*dictionary);
  }
  Measure measure(*dictionary);
  Json scenes = Json::array();
  for (int i = 0; i < rendered; ++i) {
    scenes.push_back(measure(rendered_scene("vga", *dictionary, i), "vga " + std::to_string(i)));
  }
  std::mt19937_64 random(71);
  for (int i = 0; i < upright; ++i) {
    scenes.push_back(measure(make_scene(*dictionary, 640, 480, random), "upright " + std::to_string(i)));
  }
  figures["load"] = measure(paper_load_scene(*dictionary), "paper's load");
  if (!check) {
    for (const int period : {6, 4}) {
      figures["stripes"].push_back(
          measure(striped_scene(640, 480, period), "stripes of " + std::to_string(period)));
      // The frame after one that was too much.
      scenes.push_back(measure(make_scene(*dictionary, 640, 480, random), "upright after stripes"));
    }
  }
  figures["scenes"] = scenes;
  std::cout << figures.dump(1) << '\n';
  return misses(scenes) != 0 ? 1 : 0;
}

}  // namespace
}  // namespace runmark::rtl

int main(int argc, char** argv) {
  int rendered = 300;
  int upright = 60;
  bool check = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--check") {
      check = true;
    } else if ((argument == "--scenes" || argument == "--upright") && i + 1 < argc) {
      int& number = argument == "--scenes" ? rendered : upright;
      const std::string_view text = argv[++i];
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      if (error != std::errc{} || end != text.data() + text.size() || number < 0) {
        std::cerr << "rtl_figures: " << argument << ' ' << text << ": not a number from 0\n";
        return 2;
      }
    } else {
      std::cerr << "rtl_figures: unknown argument '" << argument << "' (see the head of its main.cpp)\n";
      return 2;
    }
  }
  return runmark::rtl::run(rendered, upright, check);
}
