#include "view_loop.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <optional>

#include "annotate.h"
#include "errors.h"
#include "fitting_detector.h"
#include "interrupt.h"
#include "output_file.h"
#include "playback.h"
#include "png_file.h"
#include "pose_finder.h"
#include "view_picture.h"
#include "window.h"

namespace runmark::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int escape = 27;
constexpr int idle_milliseconds = 30;  // between looks at the window while nothing moves

const std::array<std::string, 9> help_lines{"1 original    2 threshold    3 preprocess",
                                            "4 contours    5 corners    6 sample grid    7 markers",
                                            "space    pause, go on",
                                            "n    next image; while paused, next frame",
                                            "m    next input        b    input before",
                                            "s    screenshot",
                                            "a    axes of poses, on and off",
                                            "h    this help",
                                            "q, Escape    quit"};

/// Frames a second over the last ones.
class Rate {
 public:
  void tick() {
    times_.push_back(Clock::now());
    while (times_.size() > 30) times_.pop_front();
  }
  void restart() { times_.clear(); }
  [[nodiscard]] double value() const {
    if (times_.size() < 2) return 0;
    return static_cast<double>(times_.size() - 1) /
           std::chrono::duration<double>(times_.back() - times_.front()).count();
  }

 private:
  std::deque<Clock::time_point> times_;
};

const char* name_of(Stage stage) {
  static constexpr std::array names{"original", "threshold",   "preprocess", "contours",
                                    "corners",  "sample grid", "markers"};
  return names.at(static_cast<std::size_t>(static_cast<char>(stage) - '1'));
}

std::vector<Dictionary> dictionaries_for(DetectorSettings detector, const PoseFinder& poses) {
  poses.add_dictionaries(detector);
  return load_dictionaries(detector);
}

class View {
 public:
  explicit View(const ViewSettings& settings)
      : poses_(settings.poses),
        settings_(settings),
        dictionaries_(dictionaries_for(settings.detector, poses_)),
        detector_(settings.detector.options, dictionaries_),
        playback_(find_inputs(settings.inputs)) {}

  void run() {
    forward();
    while (!quit_ && !interrupted() && !window_.closed()) {
      const bool moves = there_ && playback_.moving() && !paused_ && !at_end_;
      const int key = window_.wait_key(moves ? playback_.milliseconds_to_next() : idle_milliseconds);
      if (key != 0) {
        press(key);
      } else if (moves && playback_.milliseconds_to_next() == 0) {
        forward();
      }
    }
    if (interrupted()) throw ExitStatus{exit_interrupted};
    if (broken_) throw ExitStatus{exit_failure};
  }

 private:
  /// Goes to another frame and shows it; a broken input is told and left out. False when there is no such
  /// frame.
  template <class Step>
  bool go(const Step& step) {
    bool moved = false;
    try {
      moved = step();
      if (moved) detect();
    } catch (const InputError& error) {
      print_error(error.what());
      broken_ = true;
      if (!skip()) end();
      return true;
    }
    if (!moved) return false;
    at_end_ = false;
    there_ = true;
    rate_.tick();
    draw();
    return true;
  }

  void forward() {
    if (!go([this] { return playback_.forward(); })) end();
  }
  bool skip() {
    return go([this] { return playback_.skip(); });
  }
  void back() {
    go([this] { return playback_.back(); });
  }

  /// No frame follows.
  void end() {
    at_end_ = true;
    if (there_) {
      draw();
    } else {
      quit_ = true;
    }
  }

  void detect() {
    const auto start = Clock::now();
    const Detection found = detector_.detect(playback_.frame());
    milliseconds_ = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    markers_.assign(found.begin(), found.end());
    if (!poses_.is_idle()) found_poses_ = poses_.find(playback_.frame(), markers_);
    message_.clear();
  }

  void draw() {
    const Frame& frame = playback_.frame();
    cv::Mat picture;
    if (stage_ == Stage::markers) {
      picture = annotate(frame.pixels, markers_);
      for (const AxesPicture& axes : found_poses_.axes) {
        if (axes_) draw_axes(picture, axes);
      }
    } else {
      picture = draw_stage(frame, stage_, settings_.detector.options, dictionaries_);
    }
    const std::span<const std::string> lines =
        help_ ? std::span<const std::string>(help_lines) : std::span<const std::string>();
    shown_ = compose(picture, status(), lines);
    window_.show(shown_, "runmark view: " + state() + ": " + file_name());
  }

  [[nodiscard]] std::string state() const { return name_of(stage_) + std::string(paused_ ? ", paused" : ""); }
  [[nodiscard]] std::string file_name() const {
    return fs::path(playback_.frame().source).filename().string();
  }

  [[nodiscard]] std::string status() const {
    const Frame& frame = playback_.frame();
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "%s   %zu marker%s   %.1f ms", state().c_str(), markers_.size(),
                  markers_.size() == 1 ? "" : "s", milliseconds_);
    std::string line = text.data();
    if (playback_.moving()) {
      const auto frame_number = static_cast<long long>(frame.index);
      if (at_end_) {
        std::snprintf(text.data(), text.size(), "   end, frame %lld", frame_number);
      } else {
        std::snprintf(text.data(), text.size(), "   %.1f frames/s   frame %lld", rate_.value(), frame_number);
      }
      line += text.data();
    }
    return line + "   " + (message_.empty() ? file_name() + "   h: keys" : message_);
  }

  void press(int key) {
    message_.clear();
    switch (key) {
      case 'q':
      case escape:
        quit_ = true;
        return;
      case ' ':
        paused_ = !paused_;
        rate_.restart();
        break;
      case 'n':
        if (paused_ || !playback_.moving()) forward();
        return;
      case 'm':
        skip();
        return;
      case 'b':
        return back();
      case 's':
        save();
        break;
      case 'a':
        axes_ = !axes_;
        break;
      case 'h':
        help_ = !help_;
        break;
      default:
        if (key < static_cast<char>(Stage::original) || key > static_cast<char>(Stage::markers)) return;
        stage_ = static_cast<Stage>(key);
    }
    if (there_) draw();
  }

  /// Saves what is shown under the first free number.
  void save() {
    if (!there_) return;
    std::error_code error;
    fs::create_directories(settings_.screenshots, error);
    fs::path path;
    do {
      std::array<char, 40> name{};
      std::snprintf(name.data(), name.size(), "runmark-view-%03d.png", ++screenshots_);
      path = fs::path(settings_.screenshots) / name.data();
    } while (fs::exists(path, error));
    write_png(path.string(), shown_);
    output_.write(path.string() + '\n');
    message_ = "saved " + path.filename().string();
  }

  PoseFinder poses_;
  const ViewSettings& settings_;
  std::vector<Dictionary> dictionaries_;
  FittingDetector detector_;
  Playback playback_;
  Window window_;
  OutputFile output_;
  Rate rate_;
  std::vector<Marker> markers_;  // of the frame shown
  double milliseconds_ = 0;      // they took
  FramePoses found_poses_;
  cv::Mat shown_;
  std::string message_;
  Stage stage_ = Stage::markers;
  int screenshots_ = 0;
  bool there_ = false;   // a frame is shown
  bool at_end_ = false;  // and no other follows it
  bool paused_ = false;
  bool axes_ = true;
  bool help_ = false;
  bool broken_ = false;
  bool quit_ = false;
};

}  // namespace

void view(const ViewSettings& settings) {
  catch_interrupts();
  View(settings).run();
}

}  // namespace runmark::cli
