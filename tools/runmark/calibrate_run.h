#pragma once

#include <optional>
#include <string>
#include <vector>

#include "detector_settings.h"
#include "fitting_detector.h"
#include "frame.h"
#include "input.h"
#include "progress.h"
#include "runmark/board.h"
#include "runmark/calibration.h"

namespace runmark::cli {

struct CalibrateSettings {
  std::vector<std::string> inputs;
  DetectorSettings detector;
  std::string board;
  Lens lens = Lens::plain;
  int most_views = 60;
  std::string output;    ///< OpenCV's YAML
  std::string ros;       ///< ROS's YAML
  std::string report;    ///< a web page
  std::string coverage;  ///< a picture
};

/// One run of `calibrate`: looks for the board in all frames, chooses views, finds the camera and writes what
/// was asked for. A camera is read until Ctrl-C.
class CalibrateRun {
 public:
  /// Throws UserError, as does `run`; ExitStatus after Ctrl-C on anything but a camera.
  explicit CalibrateRun(const CalibrateSettings& settings);
  void run();

 private:
  void read_all();
  void read(const Input& input);
  void look(const Frame& frame);
  void check_board() const;
  void write(const std::vector<CalibrationView>& views, const Calibration& calibration) const;

  const CalibrateSettings& settings_;
  Board board_;
  std::vector<Input> inputs_;
  FittingDetector detector_;
  Progress progress_;
  int width_ = 0;
  int height_ = 0;
  std::int64_t frames_ = 0;
  std::size_t input_ = 0;
  std::vector<CalibrationView> views_;
  std::string advice_;
  int advised_ = 0;
};

}  // namespace runmark::cli
