#pragma once

#include <map>
#include <utility>
#include <vector>

#include "frame.h"
#include "runmark/detector.h"

namespace runmark::cli {

/// Detectors for frames of any size, so that folders of images can be worked through. There is one for
/// each power of two of width and height: what a frame gives does not depend on the frames before it.
class FittingDetector {
 public:
  FittingDetector(const Options& options, std::vector<Dictionary> dictionaries)
      : options_(options), dictionaries_(std::move(dictionaries)) {}

  /// Throws InputError for a frame no detector takes, UserError when the options or dictionaries do not
  /// suit. The markers are valid until the next call,
  /// their dictionaries' names as long as this object.
  [[nodiscard]] Detection detect(const Frame& frame);

  /// Of the last frame.
  [[nodiscard]] const FrameStats& stats() const { return current_->stats(); }

 private:
  void fit(int width, int height);

  Options options_;
  std::vector<Dictionary> dictionaries_;
  std::map<std::pair<int, int>, Detector> detectors_;  // by largest width and height
  Detector* current_ = nullptr;
};

}  // namespace runmark::cli
