#pragma once

#include <vector>

#include "runmark/pose.h"

namespace runmark {

/// The poses of a flat object that explain where its points are seen: two at most, the better one first.
/// @param object      at least four points in one plane, not all on a line
/// @param directions  where they are seen, see Camera::direction
[[nodiscard]] std::vector<Pose> planar_poses(const std::vector<Point3>& object,
                                             const std::vector<Point>& directions);

}  // namespace runmark
