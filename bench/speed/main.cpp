#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "bench/speed/median_time.h"
#include "bench/speed/report.h"
#include "evaluate/percentile.h"
#include "runmark/detector.h"

namespace runmark::bench {
namespace {

struct Arguments {
  std::vector<std::string> sets{"vga", "hd", "fullhd", "uhd"};
  int scenes = 6;
  int rounds = 20;
  int spread = 60;
  std::filesystem::path photos;
  int photo_count = 12;
  std::vector<std::string> noise_sets{"vga"};
  std::filesystem::path json;
};

int fail(const std::string& message) {
  std::cerr << "runmark-bench: " << message << '\n';
  return 2;
}

/// The median core times over the frames.
std::vector<CoreTime> median_core_times(const FrameSet& set, int rounds) {
  std::vector<CoreTime> result;
  std::vector<std::vector<double>> times;
  for (const TimedFrame& frame : set.frames) {
    result = core_times(frame, rounds);
    times.resize(result.size());
    for (std::size_t i = 0; i < result.size(); ++i) times[i].push_back(result[i].milliseconds);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    std::ranges::sort(times[i]);
    result[i].milliseconds = percentile(times[i], 0.5);
  }
  return result;
}

std::vector<FrameWork> frame_work(const FrameSet& set, int rounds) {
  std::vector<FrameWork> result;
  for (const TimedFrame& frame : set.frames) {
    Options options{.max_width = frame.grey.cols, .max_height = frame.grey.rows, .inverted = frame.inverted};
    auto detector = Detector::create(options, frame.dictionaries);
    if (!detector) throw std::runtime_error(detector.error());
    const auto view = ImageView::grey(frame.grey.data, frame.grey.cols, frame.grey.rows,
                                      static_cast<std::ptrdiff_t>(frame.grey.step[0]));
    const double time = median_time(rounds, [&] { static_cast<void>(detector->detect(view)); });
    const FrameStats& stats = detector->stats();
    result.push_back({static_cast<double>(stats.pixels), static_cast<double>(stats.crack_runs),
                      static_cast<double>(detector->markers().size()), time});
  }
  return result;
}

int run(const Arguments& arguments) {
  cv::setNumThreads(1);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  std::vector<FrameWork> work;
  const auto add = [&](const Result<FrameSet>& set, const std::string& standard, bool with_noise) {
    if (!set) return fail(set.error());
    const int rounds = arguments.rounds;
    Figures figures{measure(*set, rounds), {}, median_core_times(*set, rounds), frame_work(*set, rounds), {}};
    figures.spread = timing_of(figures.timings, "runmark");
    if (!standard.empty() && arguments.spread > arguments.scenes) {
      figures.spread = measure_alone(standard, arguments.spread, std::min(rounds, 5)).value();
    }
    if (with_noise) {
      const cv::Mat& frame = set->frames[0].grey;
      figures.noise = sweep_noise(frame.cols, frame.rows, std::min(rounds, 5));
    }
    print(*set, figures, rounds);
    work.insert(work.end(), figures.work.begin(), figures.work.end());
    all.push_back(to_json(*set, figures, rounds));
    std::printf("\n");
    std::fflush(stdout);
    return 0;
  };
  for (const std::string& name : arguments.sets) {
    const bool with_noise = std::ranges::find(arguments.noise_sets, name) != arguments.noise_sets.end();
    if (const int status = add(standard_frames(name, arguments.scenes), name, with_noise); status != 0)
      return status;
  }
  if (arguments.photo_count > 0 && std::filesystem::exists(arguments.photos)) {
    if (const int status = add(photo_frames(arguments.photos, arguments.photo_count), {}, false); status != 0)
      return status;
  } else if (arguments.photo_count > 0) {
    std::printf("photos: left out, there is no %s\n", arguments.photos.c_str());
  }
  const TimeModel model = fit_time(work);
  std::printf("all frames: %.3f ns a pixel, %.1f ns a crack run, %.0f ns a marker (relative error %.2f)\n",
              model.per_pixel, model.per_crack_run, model.per_marker, model.error);
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
  app.add_option("--spread", arguments.spread,
                 "scenes of each set on which runmark alone is timed, for its p95 over scenes")
      ->check(CLI::Range(0, 1000));
  app.add_option("--rounds", arguments.rounds, "times are medians of so many")->check(CLI::Range(1, 10000));
  app.add_option("--photos", arguments.photos, "truth file of the real photos");
  app.add_option("--photo-count", arguments.photo_count, "how many photos, 0 for none")
      ->check(CLI::Range(0, 100000));
  app.add_option("--noise", arguments.noise_sets,
                 "standard sets at whose size random frames are timed; 'none'")
      ->delimiter(',')
      ->check(CLI::IsMember({"vga", "hd", "fullhd", "uhd", "none"}));
  bool quick = false;
  app.add_flag("--quick", quick,
               "a rough look in less than a minute: 2 scenes of all but uhd, 5 rounds, no photos");
  app.add_option("--json", arguments.json, "file to write the figures to");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "runmark-bench: " << error.what() << '\n';
    return 2;
  }
  if (quick) {
    arguments.sets = {"vga", "hd", "fullhd"};
    arguments.scenes = 2;
    arguments.rounds = 5;
    arguments.spread = 0;
    arguments.photo_count = 0;
  }
  std::erase(arguments.sets, "none");
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
