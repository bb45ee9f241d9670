#pragma once

#include <optional>

#include "pose/observation.h"
#include "runmark/pose.h"

namespace runmark {

/// A refined pose and how well it fits.
struct RefinedPose {
  PoseSolution solution;
  double chi2 = 0;  ///< sum of squares of the whitened offsets
};

/// Levenberg-Marquardt from `start` on. Nothing when points come to lie behind the camera or too few
/// directions are held.
[[nodiscard]] std::optional<RefinedPose> refine_pose(const Observation& seen, const Camera& camera,
                                                     const Pose& start);

}  // namespace runmark
