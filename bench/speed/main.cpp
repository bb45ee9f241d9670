#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "bench/speed/measure.h"

namespace runmark::bench {
namespace {

struct Arguments {
  std::vector<std::string> sets{"vga", "hd", "fullhd", "uhd"};
  int scenes = 6;
  int rounds = 20;
  std::filesystem::path photos;
  int photo_count = 12;
  std::filesystem::path json;
};

int fail(const std::string& message) {
  std::cerr << "runmark-bench: " << message << '\n';
  return 2;
}

void print_table(const FrameSet& set, const std::vector<Timing>& timings, int rounds) {
  std::printf("%s: %zu frames, %.1f markers a frame, %d rounds, CPU ms a frame\n", set.name.c_str(),
              set.frames.size(), set.markers_per_frame(), rounds);
  std::printf("  %-20s %10s %10s %10s %12s\n", "", "median", "p95", "worst", "to runmark");
  const double ours = timing_of(timings, "runmark").median();
  for (const Timing& t : timings) {
    std::printf("  %-20s %10.4f %10.4f %10.4f %11.3fx\n", t.worker.c_str(), t.median(), t.p95(), t.worst(),
                t.median() / ours);
  }
  std::printf("\n");
  std::fflush(stdout);
}

nlohmann::ordered_json to_json(const FrameSet& set, const std::vector<Timing>& timings, int rounds) {
  const auto median = [&](const char* worker) { return timing_of(timings, worker).median(); };
  const Timing& ours = timing_of(timings, "runmark");
  nlohmann::ordered_json entry{{"size", set.name},
                               {"frames", set.frames.size()},
                               {"markers_per_frame", set.markers_per_frame()},
                               {"rounds", rounds},
                               {"runmark_ms", ours.median()},
                               {"copy_ratio", ours.median() / median("copy")},
                               {"opencv_ratio", median("opencv-subpix") / ours.median()},
                               {"apriltag_ratio", median("apriltag-1") / ours.median()},
                               {"apriltag_decimate2_ratio", median("apriltag-2") / ours.median()},
                               {"p95_over_median", ours.p95() / ours.median()}};
  for (const Timing& t : timings) {
    entry["ms"][t.worker] = {{"median", t.median()}, {"p95", t.p95()}, {"worst", t.worst()}};
  }
  return entry;
}

int run(const Arguments& arguments) {
  cv::setNumThreads(1);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const auto add = [&](const Result<FrameSet>& set) {
    if (!set) return fail(set.error());
    const std::vector<Timing> timings = measure(*set, arguments.rounds);
    print_table(*set, timings, arguments.rounds);
    all.push_back(to_json(*set, timings, arguments.rounds));
    return 0;
  };
  for (const std::string& name : arguments.sets) {
    if (const int status = add(standard_frames(name, arguments.scenes)); status != 0) return status;
  }
  if (arguments.photo_count > 0 && std::filesystem::exists(arguments.photos)) {
    if (const int status = add(photo_frames(arguments.photos, arguments.photo_count)); status != 0)
      return status;
  } else if (arguments.photo_count > 0) {
    std::printf("photos: left out, there is no %s\n", arguments.photos.c_str());
  }
  if (arguments.json.empty()) return 0;
  std::ofstream out(arguments.json);
  out << all.dump(1) << '\n';
  return out.flush() ? 0 : fail(arguments.json.string() + ": cannot be written");
}

std::filesystem::path default_photos() {
  const char* shared = std::getenv("RUNMARK_SHARED");
  const std::filesystem::path folder = shared != nullptr ? shared : RUNMARK_SOURCE_DIR "/../shared";
  return folder / "real-images" / "truth.json";
}

}  // namespace
}  // namespace runmark::bench

int main(int argc, char** argv) {
  using namespace runmark::bench;
  CLI::App app("Times runmark, its peers and the floor, interleaved on the same frames, one thread",
               "runmark-bench");
  Arguments arguments;
  arguments.photos = default_photos();
  app.add_option("--sets", arguments.sets, "standard sets to time on; 'none' for none")
      ->delimiter(',')
      ->check(CLI::IsMember({"vga", "hd", "fullhd", "uhd", "none"}));
  app.add_option("--scenes", arguments.scenes, "scenes of each set")->check(CLI::Range(1, 1000));
  app.add_option("--rounds", arguments.rounds, "times are medians of so many")->check(CLI::Range(1, 10000));
  app.add_option("--photos", arguments.photos, "truth file of the real photos");
  app.add_option("--photo-count", arguments.photo_count, "how many photos, 0 for none")
      ->check(CLI::Range(0, 100000));
  app.add_option("--json", arguments.json, "file to write the figures to");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "runmark-bench: " << error.what() << '\n';
    return 2;
  }
  std::erase(arguments.sets, "none");
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
