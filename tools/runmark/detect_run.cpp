#include "detect_run.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "errors.h"
#include "frame_source.h"
#include "interrupt.h"
#include "ordered_workers.h"

namespace runmark::cli {
namespace {

constexpr double default_rate = 25;  // of an annotated video whose source states none

/// As many as can have something to do.
std::size_t workers_for(const std::vector<Input>& inputs, int jobs) {
  const bool moving = std::ranges::any_of(inputs, &Input::moving);
  const auto wanted = static_cast<std::size_t>(jobs);
  return moving ? wanted : std::clamp<std::size_t>(inputs.size(), 1, wanted);
}

std::vector<FittingDetector> make_detectors(std::size_t count, const DetectorSettings& settings) {
  const std::vector<Dictionary> dictionaries = load_dictionaries(settings);
  std::vector<FittingDetector> detectors;
  for (std::size_t i = 0; i < count; ++i) detectors.emplace_back(settings.options, dictionaries);
  return detectors;
}

DetectSettings with_dictionaries(DetectSettings settings, const PoseFinder& poses) {
  poses.add_dictionaries(settings.detector);
  return settings;
}

/// The output may be none of the inputs, as in `-o a.png`.
OutputFile open_output(const DetectSettings& settings, const std::vector<Input>& inputs, std::uint64_t kept) {
  for (const Input& input : inputs) {
    std::error_code error;
    if (std::filesystem::equivalent(settings.output, input.name, error) &&
        std::filesystem::is_regular_file(input.name)) {
      throw UserError(settings.output + ": the output would replace an input");
    }
  }
  if (settings.resume) return OutputFile(settings.output, kept);
  return OutputFile(settings.output);
}

/// Goes on to the first frame that an earlier run has not given out.
void pass_over(FrameSource& source, const Input& input, std::int64_t frames) {
  for (std::int64_t i = 0; i < frames && !interrupted(); ++i) {
    if (!source.next() && !interrupted()) {
      throw InputError(input.name + ": ends after " + std::to_string(i) + " frames; an earlier run found " +
                       std::to_string(frames));
    }
  }
}

}  // namespace

DetectRun::DetectRun(DetectSettings settings)
    : poses_(settings.poses),
      settings_(with_dictionaries(std::move(settings), poses_)),
      inputs_(find_inputs(settings_.inputs)),
      earlier_(settings_.resume ? read_earlier_run(settings_.output, inputs_)
                                : EarlierRun{0, std::vector<EarlierFrames>(inputs_.size())}),
      detectors_(make_detectors(workers_for(inputs_, settings_.jobs), settings_.detector)),
      format_(make_marker_format(settings_.format, {poses_.has_poses(), settings_.row_time})),
      output_(open_output(settings_, inputs_, earlier_.bytes)),
      broken_(inputs_.size()) {
  if (settings_.confirm > 1) confirmation_.emplace(settings_.confirm);
  if (settings_.annotate.empty()) return;
  if (settings_.resume && std::ranges::any_of(inputs_, &Input::moving)) {
    throw UserError("--resume: a video cannot be annotated by two runs");
  }
  annotations_.emplace(settings_.annotate, inputs_);
}

void DetectRun::run() {
  output_.write(format_->header());
  if (detectors_.size() == 1) {
    read_all([this](Step step) {
      work(detectors_[0], step);
      put(step);
      return true;
    });
  } else {
    OrderedWorkers<Step> workers(
        detectors_.size(), [this](std::size_t worker, Step& step) { work(detectors_[worker], step); },
        [this](Step& step) { put(step); }, stop_waiting);
    read_all([&workers](Step step) { return workers.push(std::move(step)); });
    workers.finish();
  }
  output_.close();
  progress_.clear();
  if (!advice_.empty()) errors_.push_back(advice_);
  for (const std::string& error : errors_) print_error(error);
  if (interrupted()) throw ExitStatus{exit_interrupted};
  if (!errors_.empty()) throw ExitStatus{exit_failure};
}

bool DetectRun::unwanted(std::size_t input) const {
  const std::size_t broken = broken_;
  return broken == input || (settings_.strict && broken != inputs_.size());
}

void DetectRun::read_all(const Push& push) {
  for (std::size_t i = 0; i < inputs_.size() && !interrupted() && !unwanted(i); ++i) {
    if (inputs_[i].moving()) {
      read_frames(i, push);
    } else {
      Step step;
      step.input = i;
      step.rate = default_rate;
      step.last = true;
      step.earlier = earlier_.inputs[i].count > 0;
      if (!push(std::move(step))) return;
    }
  }
}

void DetectRun::read_frames(std::size_t input, const Push& push) {
  Step step;
  step.input = input;
  const EarlierFrames& earlier = earlier_.inputs[input];
  bool complete = false;
  std::unique_ptr<FrameSource> source;
  while (!step.last) {
    try {
      if (!source) {
        source = open_source(inputs_[input]);
        step.rate = source->frame_rate().value_or(default_rate);
        complete = earlier.ended && source->complete_after(earlier.count);
        if (!complete) pass_over(*source, inputs_[input], earlier.count);
      }
      if (!complete && !interrupted() && !unwanted(input)) step.frame = source->next();
      step.count = source->frame_count();
    } catch (...) {
      // A frame that Ctrl-C cut short is no fault of the input's.
      if (!interrupted()) step.error = std::current_exception();
    }
    step.last = !step.frame;
    const bool last = step.last;
    if (!push(std::move(step))) return;
    step = Step{};
    step.input = input;
    step.last = last;
  }
}

void DetectRun::work(FittingDetector& detector, Step& step) const {
  if (step.error || step.earlier) return;
  try {
    if (!inputs_[step.input].moving()) step.frame = open_source(inputs_[step.input])->next();
    if (step.frame) detect(detector, step);
  } catch (...) {
    step.error = std::current_exception();
  }
}

void DetectRun::detect(FittingDetector& detector, Step& step) const {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const Detection found = detector.detect(*step.frame);
  const std::chrono::duration<double, std::milli> time = Clock::now() - start;
  step.report = {detector.stats(), time.count()};
  step.markers.assign(found.begin(), found.end());
  if (!confirmation_) describe(step);
}

void DetectRun::describe(Step& step) const {
  if (!poses_.is_idle()) step.poses = poses_.find(*step.frame, step.markers);
  step.lines = format_->frame(*step.frame, step.markers, poses_.is_idle() ? nullptr : &step.poses,
                              settings_.stats ? &step.report : nullptr);
  if (!annotations_) step.frame->pixels.release();
}

void DetectRun::put(Step& step) {
  // Frames that were read before their input was known to be broken; its video still is to be closed.
  const bool wanted = !unwanted(step.input);
  if (!wanted && broken_ != step.input) return;
  if (annotations_ && step.rate) annotations_->begin(inputs_[step.input], *step.rate);
  if (confirmation_ && step.rate && inputs_[step.input].moving()) confirmation_->restart();
  try {
    if (wanted && step.error) std::rethrow_exception(step.error);
    if (wanted && step.frame) put_frame(step);
  } catch (const InputError& error) {
    errors_.emplace_back(error.what());
    broken_ = step.input;
  }
  if (annotations_ && step.last) annotations_->end();
}

void DetectRun::put_frame(Step& step) {
  if (confirmation_) {
    const std::span<const Marker> confirmed = confirmation_->next(step.markers);
    step.markers.assign(confirmed.begin(), confirmed.end());
    describe(step);
  }
  if (output_.is_terminal()) progress_.clear();
  // The picture first: a frame whose line is there counts as done.
  if (annotations_) annotations_->write(*step.frame, step.markers, step.poses.axes);
  output_.write(step.lines);
  if (advice_.empty() && !step.poses.advice.empty()) advice_ = step.frame->source + ": " + step.poses.advice;
  show_progress(step);
}

void DetectRun::show_progress(const Step& step) {
  ++frames_;
  const auto done = static_cast<double>(step.frame->index + 1);
  const double part = step.count ? done / static_cast<double>(*step.count) : 0;
  const bool endless = !step.count && inputs_.size() == 1;
  const double fraction =
      (static_cast<double>(step.input) + std::min(part, 1.0)) / static_cast<double>(inputs_.size());
  progress_.update(frames_, endless ? -1 : fraction);
}

}  // namespace runmark::cli
