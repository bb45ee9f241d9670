#pragma once

#include <optional>
#include <vector>

#include "frame.h"
#include "runmark/detector.h"

namespace runmark::cli {

/// A detector that is made anew when a frame is larger than all before it, so that folders of images
/// of any size can be worked through.
class FittingDetector {
 public:
  FittingDetector(const Options& options, std::vector<Dictionary> dictionaries)
      : options_(options), dictionaries_(std::move(dictionaries)) {}

  /// Throws InputError for a frame no detector takes, UserError when the options or dictionaries do not
  /// suit. The markers are valid until the next call.
  [[nodiscard]] Detection detect(const Frame& frame);

  /// Of the last frame.
  [[nodiscard]] const FrameStats& stats() const { return detector_->stats(); }

 private:
  void fit(int width, int height);

  Options options_;
  std::vector<Dictionary> dictionaries_;
  std::optional<Detector> detector_;
};

}  // namespace runmark::cli
