#pragma once

#include <array>
#include <optional>

#include "runmark/camera.h"
#include "runmark/corner_covariance.h"
#include "runmark/export.h"
#include "runmark/marker.h"
#include "runmark/result.h"

namespace runmark {

/// Where an object stands: takes points of the object's frame to the camera's.
///
/// A marker's frame has its origin in the centre of the black square (AprilTag 3's reversed families: of the
/// detected square), x along the upper side to the right, y down, z into the sheet: a marker that faces the
/// camera upright has the identity as rotation. AprilTag 3's poses and the boards of OpenCV since 4.6 are
/// alike; OpenCV's SOLVEPNP_IPPE_SQUARE has y and z the other way round.
struct Pose {
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< row-major
  Point3 translation;  ///< of the object's origin, in the unit of its size

  /// A point of the object's frame in the camera's.
  [[nodiscard]] RUNMARK_EXPORT Point3 operator()(const Point3& point) const;
  /// The camera's pose in the object's frame.
  [[nodiscard]] RUNMARK_EXPORT Pose inverse() const;
};

/// First `inner`, then `outer`: marker B in A's frame is a.inverse() * b.
[[nodiscard]] RUNMARK_EXPORT Pose operator*(const Pose& outer, const Pose& inner);

/// Rotation as x, y, z, w of a unit quaternion with w >= 0.
[[nodiscard]] RUNMARK_EXPORT std::array<double, 4> quaternion(const Pose& pose);

/// Rotation as OpenCV's rvec: its axis, as long as its angle in radians.
[[nodiscard]] RUNMARK_EXPORT Point3 rotation_vector(const Pose& pose);
[[nodiscard]] RUNMARK_EXPORT Pose pose_from(const Point3& rotation_vector, const Point3& translation);

/// Covariance of a pose, 6x6 row-major: x, y, z of the translation in the unit of the object's size, then
/// the rotation about the camera's x, y and z axes in radians, as in ROS's PoseWithCovariance. The true
/// rotation is exp(r) times the estimated one for such a small r.
using PoseCovariance = std::array<double, 36>;

/// A pose that explains the corners, refined: it makes the squares of the corners' offsets, weighted by
/// their covariance, least.
struct PoseSolution {
  Pose pose;
  double error = 0;  ///< rms distance of the projected corners from those seen, in pixels
  PoseCovariance covariance{};
};

/// What the corners of a flat thing say of its pose: often two answers that explain them almost alike.
/// Source of the two: T. Collins and A. Bartoli, "Infinitesimal plane-based pose estimation", IJCV 2014,
/// by OpenCV's SOLVEPNP_IPPE.
struct PoseEstimate {
  PoseSolution best;
  std::optional<PoseSolution> other;  ///< none when there is one answer only
  /// How much better best fits: its error over other's, both weighted by the corners' covariance. Near 0 best
  /// is right, near 1 either may be; 0 without other.
  double ambiguity = 0;
};

/// The pose of a marker whose side is `size` long (any unit; translations come in it). Errors: a size or a
/// camera that makes no sense, corners that no marker before the camera has.
[[nodiscard]] RUNMARK_EXPORT Result<PoseEstimate> pose(const Marker& marker, double size,
                                                       const Camera& camera, const CornerCovariance& corners);

/// The same with what a marker alone says of its corners' uncertainty.
[[nodiscard]] RUNMARK_EXPORT Result<PoseEstimate> pose(const Marker& marker, double size,
                                                       const Camera& camera);

}  // namespace runmark
