#pragma once

#include <string>
#include <vector>

#include "runmark/calibration.h"

namespace runmark {

/// What OpenCV makes of views; `poses` are in their order.
struct RawCalibration {
  Camera camera;
  std::vector<double> deviations;
  std::vector<Pose> poses;
};

/// Coefficients of a plain lens to be held at 0.
struct HeldCoefficients {
  bool k3 = false;
  bool tangential = false;
};

/// Errors: what OpenCV found wrong.
[[nodiscard]] Result<RawCalibration> calibrate_by_opencv(const std::vector<const CalibrationView*>& views,
                                                         int width, int height, Lens lens,
                                                         HeldCoefficients held);

}  // namespace runmark
