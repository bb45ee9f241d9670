#pragma once

#include <array>
#include <string>

#include "pose/observation.h"
#include "runmark/pose.h"

namespace runmark {

/// The corners of a marker in its own frame.
[[nodiscard]] std::array<Point3, 4> marker_corners(double size);

/// Both poses of points in one plane, refined. `what` begins the error's text.
[[nodiscard]] Result<PoseEstimate> planar_pose(const Observation& seen, const Camera& camera,
                                               const std::string& what);

}  // namespace runmark
