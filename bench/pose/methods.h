#pragma once

#include <apriltag/apriltag.h>

#include <memory>
#include <opencv2/aruco.hpp>
#include <optional>
#include <string_view>

#include "runmark/detector.h"
#include "runmark/pose.h"

namespace runmark::bench {

/// A way from a picture to the pose of the one tag36h11 marker in it, in runmark's convention.
class PoseMethod {
 public:
  PoseMethod() = default;
  PoseMethod(const PoseMethod&) = delete;
  PoseMethod& operator=(const PoseMethod&) = delete;
  virtual ~PoseMethod() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// @param size  of the marker; the camera has no distortion
  [[nodiscard]] virtual std::optional<Pose> find(const cv::Mat& grey, int id, double size,
                                                 const Camera& camera) = 0;
  /// Mean time of a pose, without finding the marker.
  [[nodiscard]] double microseconds() const { return calls_ == 0 ? 0 : time_ / calls_; }

 protected:
  double time_ = 0;
  int calls_ = 0;
};

/// runmark's detector and runmark::pose with the corners' covariance from the picture.
[[nodiscard]] std::unique_ptr<PoseMethod> runmark_pose();
/// OpenCV's ArUco with sub-pixel corners, and solvePnP with SOLVEPNP_IPPE_SQUARE.
[[nodiscard]] std::unique_ptr<PoseMethod> opencv_pose();
/// AprilTag 3 (decimate 1), and its estimate_tag_pose.
[[nodiscard]] std::unique_ptr<PoseMethod> apriltag_pose();

}  // namespace runmark::bench
