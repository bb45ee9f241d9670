#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "boards/board_markers.h"
#include "pose/opencv_pose.h"
#include "pose/planar_pose.h"
#include "pose/refine_pose.h"
#include "runmark/board_view.h"

namespace runmark {
namespace {

constexpr const char* name = "the board";

/// How widely points are spread, as the square roots of the eigenvalues of their scatter, the largest first.
cv::Vec3d spread(const std::vector<Point3>& points) {
  cv::Vec3d mean;
  for (const Point3& p : points) mean += cv::Vec3d(p.x, p.y, p.z);
  mean *= 1.0 / static_cast<double>(std::max<std::size_t>(points.size(), 1));
  cv::Matx33d scatter;
  for (const Point3& p : points) {
    const cv::Vec3d d = cv::Vec3d(p.x, p.y, p.z) - mean;
    scatter += d * d.t();
  }
  cv::Vec3d values;
  cv::eigen(scatter, values);
  for (int i = 0; i < 3; ++i) values[i] = std::sqrt(std::max(0.0, values[i]));
  return values;
}

/// The pose of points that do not lie in a plane. Source: G. Terzakis and M. Lourakis, "A consistently fast
/// and globally optimal solution to the perspective-n-point problem", ECCV 2020, by OpenCV's SOLVEPNP_SQPNP.
Result<PoseEstimate> pose_in_space(const Observation& seen, const Camera& camera) {
  std::vector<cv::Point3d> object;
  std::vector<cv::Point2d> directions;
  for (const Point3& p : seen.object) object.emplace_back(p.x, p.y, p.z);
  for (const Point& place : seen.image) {
    const std::optional<Point> direction = camera.direction(place);
    if (!direction)
      return Error{std::string(name) + " lies where the lens model of the camera does not hold"};
    directions.emplace_back(direction->x, direction->y);
  }
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> places;
  cv::solvePnPGeneric(object, directions, cv::Matx33d::eye(), cv::noArray(), turns, places, false,
                      cv::SOLVEPNP_SQPNP);
  std::optional<RefinedPose> best;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto refined = refine_pose(seen, camera, pose_from_opencv(turns[i], places[i]));
    if (refined && (!best || refined->chi2 < best->chi2)) best = refined;
  }
  if (!best) return Error{std::string(name) + ": no pose explains the corners"};
  return PoseEstimate{best->solution, {}, 0};
}

Result<PoseEstimate> pose_of(const Observation& seen, const Camera& camera) {
  const cv::Vec3d wide = spread(seen.object);
  if (seen.object.size() < 4 || !(wide[1] > 1e-6 * wide[0])) {
    return Error{"too little of " + std::string(name) +
                 " is seen: four corners that are not on one line are needed"};
  }
  return wide[2] > 1e-6 * wide[0] ? pose_in_space(seen, camera) : planar_pose(seen, camera, name);
}

/// rms distance of a marker's corners from where the pose has them, in pixels; infinite behind the camera.
double error_of(const BoardMarker& place, const Marker& marker, const Pose& pose, const Camera& camera) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> p = camera.project(pose(place.corners[i]));
    if (!p) return std::numeric_limits<double>::infinity();
    sum += (p->x - marker.corners[i].x) * (p->x - marker.corners[i].x) +
           (p->y - marker.corners[i].y) * (p->y - marker.corners[i].y);
  }
  return std::sqrt(sum / 4);
}

}  // namespace

Result<PoseEstimate> pose(const Board& board, const BoardView& view, const Camera& camera) {
  constexpr double clearly_off = 3;  // pixels, and times the middle one's error
  if (!camera.is_valid()) return Error{"the camera's numbers make no sense"};
  std::vector<const SeenMarker*> markers;
  for (const SeenMarker& m : view.markers) {
    if (m.index < 0 || static_cast<std::size_t>(m.index) >= board.markers.size()) {
      return Error{"the view has a marker that is not the board's"};
    }
    markers.push_back(&m);
  }
  for (;;) {
    Observation seen;
    for (const SeenMarker* m : markers) {
      const BoardMarker& place = board.markers[static_cast<std::size_t>(m->index)];
      if (!seen.add_marker(place.corners, m->marker.corners, m->covariance)) {
        return Error{"the covariance of the corners of marker " + std::to_string(place.id) +
                     " is not positive definite"};
      }
    }
    for (const SeenCorner& c : view.corners) {
      if (c.index < 0 || static_cast<std::size_t>(c.index) >= board.chess_corners.size() ||
          !(c.deviation > 0)) {
        return Error{"the view has a corner that is not the board's, or without a deviation"};
      }
      seen.add_point(board.chess_corners[static_cast<std::size_t>(c.index)], c.place, c.deviation);
    }
    Result<PoseEstimate> estimate = pose_of(seen, camera);
    if (!estimate || markers.size() < 3) return estimate;
    std::vector<double> errors;
    for (const SeenMarker* m : markers) {
      errors.push_back(error_of(board.markers[static_cast<std::size_t>(m->index)], m->marker,
                                estimate->best.pose, camera));
    }
    const auto worst = std::max_element(errors.begin(), errors.end());
    std::vector<double> sorted = errors;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    if (*worst < clearly_off * std::max(1.0, sorted[sorted.size() / 2])) return estimate;
    markers.erase(markers.begin() + (worst - errors.begin()));
  }
}

}  // namespace runmark
