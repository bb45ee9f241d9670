#pragma once

#include <string>
#include <vector>

#include "runmark/calibration.h"

namespace runmark::cli {

/// What `runmark calibrate` prints: the camera, each view, what was left out and why, where corners are
/// missing.
[[nodiscard]] std::string calibration_text(const std::vector<CalibrationView>& views,
                                           const Calibration& calibration);

/// The same as a web page of its own with plots: coverage, offsets, offsets over the picture, errors of the
/// views.
[[nodiscard]] std::string calibration_page(const std::vector<CalibrationView>& views,
                                           const Calibration& calibration);

}  // namespace runmark::cli
