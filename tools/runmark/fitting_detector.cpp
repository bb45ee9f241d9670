#include "fitting_detector.h"

#include <string>

#include "errors.h"
#include "pipeline/size_class.h"

namespace runmark::cli {

Detection FittingDetector::detect(const Frame& frame) {
  const ImageView view = frame.view();
  if (const Status status = view.check(); status != Status::ok) {
    throw InputError(frame.source + ": frame " + std::to_string(frame.index) + ": " +
                     std::string(describe(status)));
  }
  fit(view.width, view.height);
  const Detection found = current_->detect(view);
  if (found.status == Status::ok) return found;
  throw InputError(frame.source + ": frame " + std::to_string(frame.index) + ": " +
                   std::string(describe(found.status)));
}

void FittingDetector::fit(int width, int height) {
  options_.max_width = size_class(width);
  options_.max_height = size_class(height);
  const std::pair size(options_.max_width, options_.max_height);
  auto known = detectors_.find(size);
  if (known == detectors_.end()) {
    known = detectors_.emplace(size, value_or_throw(Detector::create(options_, dictionaries_))).first;
  }
  current_ = &known->second;
}

}  // namespace runmark::cli
