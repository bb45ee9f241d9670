// Figures of both profiles that only a simulation can give, as JSON for fpga/synth/report: cycles, record
// peaks, markers found with the hardware's records and without a limit, waiting times.
//   rtl_figures [--scenes N] [--upright N] [--check]
// Returns 1 when a scene misses a target. --check measures these scenes only.

#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "match_clocks.h"
#include "measure.h"
#include "scenes.h"

namespace runmark::rtl {
namespace {

using Json = nlohmann::json;

constexpr const char* dictionary_name = "DICT_6X6_250";

/// Record peaks of the plain pipeline in rendered scenes of other sizes.
Json growth(const Dictionary& dictionary, Pipeline pipeline) {
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
    auto detector = Detector::create(options_of(pipeline, size.width, size.height), {dictionary});
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

/// Says what misses a target.
int misses(const Json& scenes, double most_cycles_per_pixel) {
  int count = 0;
  const auto miss = [&](const Json& scene, const std::string& what) {
    std::cerr << "rtl_figures: " << scene["name"].get<std::string>() << ": " << what << '\n';
    ++count;
  };
  for (const Json& scene : scenes) {
    if (!scene["ended"]) miss(scene, "the frame does not end");
    if (scene["missed"] != 0)
      miss(scene, scene["missed"].dump() + " markers missed with the records there are");
    if (scene["events_per_100_pixels"] < 10 && scene["cycles_per_pixel"] > most_cycles_per_pixel) {
      miss(scene, scene["cycles_per_pixel"].dump() + " cycles a pixel");
    }
  }
  return count;
}

struct Scope {
  int rendered = 300;
  int upright = 60;
  bool check = false;
};

template <class Cores>
Json measure_profile(const Dictionary& dictionary, const Scope& scope) {
  Measure<Cores> measure(dictionary);
  Json figures;
  if (!scope.check) figures["growth"] = growth(dictionary, Cores::pipeline);
  Json scenes = Json::array();
  for (int i = 0; i < scope.rendered; ++i) {
    scenes.push_back(measure(rendered_scene("vga", dictionary, i), "vga " + std::to_string(i)));
  }
  std::mt19937_64 random(71);
  for (int i = 0; i < scope.upright; ++i) {
    scenes.push_back(measure(make_scene(dictionary, 640, 480, random), "upright " + std::to_string(i)));
  }
  figures["load"] = measure(paper_load_scene(dictionary), "paper's load");
  if (!scope.check) {
    for (const int period : {6, 4}) {
      figures["stripes"].push_back(
          measure(striped_scene(640, 480, period), "stripes of " + std::to_string(period)));
      // The frame after one that was too much.
      scenes.push_back(measure(scope.upright > 0 ? make_scene(dictionary, 640, 480, random)
                                                 : rendered_scene("vga", dictionary, 10),
                               "after stripes"));
    }
  }
  figures["scenes"] = scenes;
  return figures;
}

int run(const Scope& scope) {
  const auto dictionary = builtin_dictionary(dictionary_name);
  if (!dictionary) return 2;
  Json figures{{"memory_latency", memory_latency}, {"dictionary", dictionary_name}};
  if (!scope.check) {
    for (const unsigned codes : {1U, 50U, 250U, 1000U}) {
      figures["match"].push_back({{"codes", codes}, {"clocks", match_clocks(codes, memory_latency)}});
    }
  }
  figures["paper"] = measure_profile<PaperCores>(*dictionary, scope);
  // The ground of the upright scenes is speckled below a fixed threshold; to one that follows the light it is
  // all noise.
  figures["hardware"] = measure_profile<HardwareCores>(*dictionary, {scope.rendered, 0, scope.check});
  std::cout << figures.dump(1) << '\n';
  // The hardware profile sends eight rows more after the last one has come in.
  const int missed = misses(figures["paper"]["scenes"], 1.02) + misses(figures["hardware"]["scenes"], 1.05);
  return missed != 0 ? 1 : 0;
}

}  // namespace
}  // namespace runmark::rtl

int main(int argc, char** argv) {
  runmark::rtl::Scope scope;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--check") {
      scope.check = true;
    } else if ((argument == "--scenes" || argument == "--upright") && i + 1 < argc) {
      int& number = argument == "--scenes" ? scope.rendered : scope.upright;
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
  return runmark::rtl::run(scope);
}
