#include "fitting_detector.h"

#include <algorithm>
#include <bit>
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
  const Detection found = current_->detect(view);
  if (found.status == Status::ok) return found;
  throw InputError(frame.source + ": frame " + std::to_string(frame.index) + ": " +
                   std::string(describe(found.status)));
}

void FittingDetector::fit(int width, int height) {
  static constexpr int most_side = 65535;
  const auto rounded = [](int side) {
    return std::min(static_cast<int>(std::bit_ceil(static_cast<unsigned>(side))), most_side);
  };
  options_.max_width = rounded(width);
  options_.max_height = rounded(height);
  const std::pair size(options_.max_width, options_.max_height);
  auto known = detectors_.find(size);
  if (known == detectors_.end()) {
    known = detectors_.emplace(size, value_or_throw(Detector::create(options_, dictionaries_))).first;
  }
  current_ = &known->second;
}

}  // namespace runmark::cli
