#include "detect_command.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "annotation_output.h"
#include "detector_settings.h"
#include "errors.h"
#include "fitting_detector.h"
#include "frame_source.h"
#include "input.h"
#include "interrupt.h"
#include "marker_format.h"
#include "output_file.h"
#include "progress.h"

namespace runmark::cli {
namespace {

constexpr double default_rate = 25;  // of an annotated video whose source states none

struct DetectSettings {
  std::vector<std::string> inputs;
  DetectorSettings detector;
  std::string format = "text";
  std::string output;
  std::string annotate;
  bool stats = false;
  bool strict = false;
};

/// One run of the command: all inputs, one after the other.
class DetectRun {
 public:
  explicit DetectRun(const DetectSettings& settings)
      : settings_(settings),
        inputs_(find_inputs(settings.inputs)),
        detector_(settings.detector.options, load_dictionaries(settings.detector)),
        format_(make_marker_format(settings.format)),
        output_(settings.output) {
    if (!settings.annotate.empty()) annotations_.emplace(settings.annotate, inputs_);
  }

  void run() {
    output_.write(format_->header());
    for (std::size_t i = 0; i < inputs_.size() && !interrupted(); ++i) {
      if (settings_.strict && !errors_.empty()) break;
      run_input(i);
    }
    output_.close();
    progress_.clear();
    for (const std::string& error : errors_) print_error(error);
    if (interrupted()) throw ExitStatus{exit_interrupted};
    if (!errors_.empty()) throw ExitStatus{exit_failure};
  }

 private:
  /// All frames of one input; an input that breaks is noted, and what it gave before stays.
  void run_input(std::size_t number) {
    try {
      const std::unique_ptr<FrameSource> source = open_source(inputs_[number]);
      if (annotations_) annotations_->begin(inputs_[number], source->frame_rate().value_or(default_rate));
      while (!interrupted()) {
        const std::optional<Frame> frame = source->next();
        if (!frame) break;
        run_frame(*frame);
        show_progress(number, frame->index + 1, source->frame_count());
      }
    } catch (const InputError& error) {
      errors_.emplace_back(error.what());
    }
    if (annotations_) annotations_->end();
  }

  void run_frame(const Frame& frame) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const Detection found = detector_.detect(frame);
    const std::chrono::duration<double, std::milli> time = Clock::now() - start;
    const FrameReport report{detector_.stats(), time.count()};
    if (output_.is_terminal()) progress_.clear();
    output_.write(format_->frame(frame, found.markers, settings_.stats ? &report : nullptr));
    if (annotations_) annotations_->write(frame, found.markers);
  }

  void show_progress(std::size_t number, std::int64_t done, std::optional<std::int64_t> count) {
    ++frames_;
    const auto inputs = static_cast<double>(inputs_.size());
    const double part = count ? static_cast<double>(done) / static_cast<double>(*count) : 0;
    const bool endless = !count && inputs_.size() == 1;
    progress_.update(frames_, endless ? -1 : (static_cast<double>(number) + std::min(part, 1.0)) / inputs);
  }

  const DetectSettings& settings_;
  std::vector<Input> inputs_;
  FittingDetector detector_;
  std::unique_ptr<MarkerFormat> format_;
  OutputFile output_;
  std::optional<AnnotationOutput> annotations_;
  Progress progress_;
  std::int64_t frames_ = 0;
  std::vector<std::string> errors_;
};

}  // namespace

void add_detect_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("detect", "Find markers and print them");
  const auto settings = std::make_shared<DetectSettings>();
  command->add_option("INPUT", settings->inputs, input_help)->required()->type_name("");
  add_detector_options(*command, settings->detector);
  command->add_option("-f,--format", settings->format, "How markers are printed (text)")
      ->check(CLI::IsMember({"text", "jsonl", "csv"}).description(""))
      ->type_name("text|jsonl|csv");
  command->add_option("-o,--output", settings->output, "Print into this file instead of standard output")
      ->type_name("FILE");
  command
      ->add_option("--annotate", settings->annotate,
                   "Draw the markers into the pictures: an image file for one image, an .mp4 or .avi for "
                   "one video, a folder for several inputs")
      ->type_name("PATH");
  command->add_flag("--stats", settings->stats, "Also print each frame's time and counts (not with csv)");
  command->add_flag("--strict", settings->strict, "Stop at the first input that cannot be read");
  command->footer(
      "Pixels are taken as stored: an EXIF or video rotation is not applied. The centre of the top-left\n"
      "pixel is (0, 0); corners run from the marker's top-left clockwise.\n"
      "Exit status: 0, also when nothing was found; 2 when something went wrong; 130 after Ctrl-C.");
  command->callback([settings] {
    if (settings->stats && settings->format == "csv") throw UserError("--stats has no place in csv");
    catch_interrupts();
    DetectRun(*settings).run();
  });
}

}  // namespace runmark::cli
