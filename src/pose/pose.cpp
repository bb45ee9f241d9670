#include "runmark/pose.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "corner/quad.h"
#include "pose/planar_pose.h"
#include "pose/planar_poses.h"
#include "pose/refine_pose.h"

namespace runmark {
namespace {

bool are_finite(const std::array<Point, 4>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

bool are_one(const Pose& a, const Pose& b) {
  const Point3 turn = rotation_vector(a.inverse() * b);
  return std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z) < 1e-4;
}

std::string name_of(const Marker& marker) {
  return "marker " + std::to_string(marker.id) + " of " + std::string(marker.dictionary);
}

}  // namespace

std::array<Point3, 4> marker_corners(double size) {
  const double h = size / 2;
  return {Point3{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
}

Result<PoseEstimate> pose(const Marker& marker, double size, const Camera& camera,
                          const CornerCovariance& corners) {
  if (!(size > 0) || !std::isfinite(size))
    return Error{"the size of " + name_of(marker) + " is not positive"};
  if (!camera.is_valid()) return Error{"the camera's numbers make no sense"};
  if (!are_finite(marker.corners) || !is_convex_clockwise(marker.corners)) {
    return Error{"the corners of " + name_of(marker) + " are not those of a square seen from its front"};
  }
  Observation seen;
  if (!seen.add_marker(marker_corners(size), marker.corners, corners)) {
    return Error{"the covariance of the corners of " + name_of(marker) + " is not positive definite"};
  }
  return planar_pose(seen, camera, name_of(marker));
}

Result<PoseEstimate> pose(const Marker& marker, double size, const Camera& camera) {
  return pose(marker, size, camera, corner_covariance(marker));
}

Result<PoseEstimate> planar_pose(const Observation& seen, const Camera& camera, const std::string& what) {
  std::vector<Point> directions;
  for (const Point& place : seen.image) {
    const std::optional<Point> direction = camera.direction(place);
    if (!direction) return Error{what + " lies where the lens model of the camera does not hold"};
    directions.push_back(*direction);
  }
  std::vector<RefinedPose> found;
  for (const Pose& start : planar_poses(seen.object, directions)) {
    std::optional<RefinedPose> refined = refine_pose(seen, camera, start);
    if (refined) found.push_back(*refined);
  }
  if (found.empty()) return Error{what + ": no pose explains the corners"};
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.chi2 < b.chi2; });
  PoseEstimate estimate{found[0].solution, {}, 0};
  if (found.size() > 1 && !are_one(found[0].solution.pose, found[1].solution.pose)) {
    estimate.other = found[1].solution;
    estimate.ambiguity = found[1].chi2 > 0 ? std::sqrt(found[0].chi2 / found[1].chi2) : 1;
  }
  return estimate;
}

}  // namespace runmark
