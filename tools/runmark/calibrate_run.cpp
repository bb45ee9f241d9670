#include "calibrate_run.h"

#include <algorithm>

#include "calibration_report.h"
#include "coverage.h"
#include "errors.h"
#include "frame_source.h"
#include "interrupt.h"
#include "output_file.h"
#include "runmark/board_file.h"
#include "runmark/board_view.h"
#include "runmark/camera_file.h"

namespace runmark::cli {
namespace {

DetectorSettings with_dictionaries(DetectorSettings detector, const Board& board) {
  add_dictionaries_of(board, detector);
  return detector;
}

}  // namespace

CalibrateRun::CalibrateRun(const CalibrateSettings& settings)
    : settings_(settings),
      board_(value_or_throw(load_board(settings.board))),
      inputs_(find_inputs(settings.inputs)),
      detector_(settings.detector.options, load_dictionaries(with_dictionaries(settings.detector, board_))) {}

void CalibrateRun::run() {
  read_all();
  progress_.clear();
  const bool live = std::ranges::any_of(inputs_, [](const Input& i) { return i.kind == InputKind::camera; });
  if (interrupted() && !live) throw ExitStatus{exit_interrupted};
  check_board();
  std::vector<CalibrationView> views;
  for (const std::size_t i : most_different(views_, static_cast<std::size_t>(settings_.most_views))) {
    views.push_back(std::move(views_[i]));
  }
  if (views.size() < 3) {
    throw UserError("the board is seen well enough in " + std::to_string(views.size()) + " of " +
                    std::to_string(frames_) +
                    " frames; a calibration needs at least 3 different views, better 15");
  }
  const Calibration calibration = value_or_throw(calibrate(views, width_, height_, settings_.lens));
  write(views, calibration);
}

void CalibrateRun::read_all() {
  for (input_ = 0; input_ < inputs_.size() && !interrupted(); ++input_) read(inputs_[input_]);
}

void CalibrateRun::read(const Input& input) {
  const std::unique_ptr<FrameSource> source = open_source(input);
  for (std::optional<Frame> frame = source->next(); frame && !interrupted(); frame = source->next()) {
    look(*frame);
    const auto count = source->frame_count();
    const double part =
        count ? std::min(1.0, static_cast<double>(frame->index + 1) / static_cast<double>(*count)) : 1;
    const bool endless = input.moving() && !count;
    progress_.update(
        frames_, endless ? -1 : (static_cast<double>(input_) + part) / static_cast<double>(inputs_.size()));
  }
}

void CalibrateRun::look(const Frame& frame) {
  // Of a long video only so many are kept at a time.
  constexpr std::size_t most_kept = 240;
  if (width_ == 0) {
    width_ = frame.pixels.cols;
    height_ = frame.pixels.rows;
  } else if (width_ != frame.pixels.cols || height_ != frame.pixels.rows) {
    throw InputError(frame.source + ": is " + std::to_string(frame.pixels.cols) + " x " +
                     std::to_string(frame.pixels.rows) + " pixels, but the frames before are " +
                     std::to_string(width_) + " x " + std::to_string(height_));
  }
  ++frames_;
  const Detection found = detector_.detect(frame);
  const std::string advice = layout_advice(board_, found.markers);
  if (!advice.empty()) {
    if (advised_++ == 0) advice_ = frame.source + ": " + advice;
    return;
  }
  const std::string name =
      frame.still ? frame.source : frame.source + " frame " + std::to_string(frame.index);
  CalibrationView view = calibration_view(board_, view_board(board_, found.markers, frame.view()), name);
  if (view.object.empty()) return;
  views_.push_back(std::move(view));
  if (views_.size() < most_kept) return;
  std::vector<CalibrationView> kept;
  for (const std::size_t i : most_different(views_, most_kept / 2)) kept.push_back(std::move(views_[i]));
  views_ = std::move(kept);
}

void CalibrateRun::check_board() const {
  if (advised_ > static_cast<int>(views_.size())) throw UserError(advice_);
}

void CalibrateRun::write(const std::vector<CalibrationView>& views, const Calibration& calibration) const {
  const auto file = [](const std::string& path, const std::string& text) {
    if (!path.empty()) write_file(path, text);
  };
  file(settings_.output, camera_text(calibration.camera, CameraFormat::opencv, calibration.error));
  file(settings_.ros, camera_text(calibration.camera, CameraFormat::ros, calibration.error));
  file(settings_.report, calibration_page(views, calibration));
  if (!settings_.coverage.empty()) write_coverage_picture(settings_.coverage, views, calibration);
  OutputFile output;
  output.write(calibration_text(views, calibration));
  output.close();
}

}  // namespace runmark::cli
