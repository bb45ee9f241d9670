#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "annotation_output.h"
#include "detector_settings.h"
#include "earlier_run.h"
#include "fitting_detector.h"
#include "frame.h"
#include "input.h"
#include "marker_format.h"
#include "output_file.h"
#include "pose_finder.h"
#include "progress.h"
#include "runmark/confirmation.h"

namespace runmark::cli {

struct DetectSettings {
  std::vector<std::string> inputs;
  DetectorSettings detector;
  PoseSettings poses;
  std::string format = "text";
  std::string output;
  bool resume = false;  ///< go on with what an earlier run wrote to `output`
  std::string annotate;
  int confirm = 1;      ///< frames a marker must be seen in
  double row_time = 0;  ///< of a rolling shutter, microseconds from row to row; 0: not asked for
  bool stats = false;
  bool strict = false;
  int jobs = 1;
};

/// One run of `detect`: all inputs, put out in their order. With several jobs videos are decoded in the
/// calling thread while others detect, and images are decoded where they are detected in.
class DetectRun {
 public:
  /// Throws UserError, as does `run`; ExitStatus when the run ends with one after all has been said.
  explicit DetectRun(DetectSettings settings);
  void run();

 private:
  /// One turn of the run: a frame, an input's beginning, its end, or several of these.
  struct Step {
    std::size_t input = 0;
    std::optional<double> rate;         ///< the input begins with this step: frames a second
    bool last = false;                  ///< and ends with it
    bool earlier = false;               ///< an image whose line an earlier run has written
    std::optional<Frame> frame;         ///< of an image, read only by the worker
    std::optional<std::int64_t> count;  ///< frames of the input, where known
    std::exception_ptr error;           ///< what came instead of the frame
    std::vector<Marker> markers;
    FrameReport report;
    FramePoses poses;
    std::string lines;
  };
  using Push = std::function<bool(Step)>;  ///< false when no more is wanted

  void read_all(const Push& push);
  void read_frames(std::size_t input, const Push& push);
  void work(FittingDetector& detector, Step& step) const;
  void detect(FittingDetector& detector, Step& step) const;
  /// What is to be said of the step's markers.
  void describe(Step& step) const;
  void put(Step& step);
  void put_frame(Step& step);
  void show_progress(const Step& step);
  /// Whether no frame after what went wrong at `input` is wanted.
  [[nodiscard]] bool unwanted(std::size_t input) const;

  PoseFinder poses_;
  DetectSettings settings_;
  std::vector<Input> inputs_;
  EarlierRun earlier_;
  std::vector<FittingDetector> detectors_;  // a worker each
  std::unique_ptr<MarkerFormat> format_;
  OutputFile output_;
  std::optional<AnnotationOutput> annotations_;
  std::optional<Confirmation> confirmation_;  // sees the frames in their order
  Progress progress_;
  std::int64_t frames_ = 0;
  std::string advice_;  // about the board, of the first frame that has some
  std::vector<std::string> errors_;
  std::atomic<std::size_t> broken_;  // the last input that broke; inputs_.size() before any did
};

}  // namespace runmark::cli
