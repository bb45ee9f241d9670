#include "fitting_detector.h"

#include <algorithm>
#include <string>

#include "errors.h"

namespace runmark::cli {

Detection FittingDetector::detect(const Frame& frame) {
  const ImageView view = frame.view();
  if (const Status status = view.check(); status != Status::ok) {
    throw InputError(frame.source + ": frame " + std::to_string(frame.index) + ": " +
                     std::string(describe(status)));
  }
  fit(view.width, view.height);
  const Detection found = detector_->detect(view);
  if (found.status == Status::ok) return found;
  throw InputError(frame.source + ": frame " + std::to_string(frame.index) + ": " +
                   std::string(describe(found.status)));
}

void FittingDetector::fit(int width, int height) {
  if (detector_ && width <= options_.max_width && height <= options_.max_height) return;
  options_.max_width = detector_ ? std::max(width, options_.max_width) : width;
  options_.max_height = detector_ ? std::max(height, options_.max_height) : height;
  detector_.emplace(value_or_throw(Detector::create(options_, dictionaries_)));
}

}  // namespace runmark::cli
