#pragma once

#include <cmath>

#include "render/scene.h"
#include "runmark/pose.h"

namespace runmark::test {

/// The renderer's camera as a calibrated one; its lens, by the division model, is left out.
inline Camera camera_of(const render::Camera& c) {
  Camera camera;
  camera.width = c.width;
  camera.height = c.height;
  camera.fx = camera.fy = c.focal;
  camera.cx = c.centre_x();
  camera.cy = c.centre_y();
  return camera;
}

/// The pose of a plane whose point (u, v) is the object's origin; lengths in the scene's own unit.
inline Pose pose_of(const render::PlanePose& plane, double u, double v) {
  const render::Vec3 x = render::unit(plane.along_u);
  const render::Vec3 y = render::unit(plane.along_v);
  const render::Vec3 z = render::cross(x, y);
  const render::Vec3 t = plane.at(u, v);
  return {{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}, {t.x, t.y, t.z}};
}

/// How long the plane's unit is.
inline double unit_of(const render::PlanePose& plane) {
  return std::sqrt(render::dot(plane.along_u, plane.along_u));
}

/// From the estimated pose to the true one: x, y, z, then the rotation about the camera's axes.
inline std::array<double, 6> difference(const Pose& estimated, const Pose& truth) {
  const Point3 turn = rotation_vector(truth * estimated.inverse());
  return {truth.translation.x - estimated.translation.x,
          truth.translation.y - estimated.translation.y,
          truth.translation.z - estimated.translation.z,
          turn.x,
          turn.y,
          turn.z};
}

inline double turn_between(const Pose& a, const Pose& b) {
  const std::array<double, 6> d = difference(a, b);
  return std::sqrt(d[3] * d[3] + d[4] * d[4] + d[5] * d[5]);
}

inline double distance_between(const Pose& a, const Pose& b) {
  const std::array<double, 6> d = difference(a, b);
  return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

/// The square of the difference in units of its covariance: chi-square with as many degrees of freedom.
template <std::size_t n>
double mahalanobis2(const std::array<double, n * n>& covariance, const std::array<double, n>& difference) {
  // Forward substitution with the Cholesky factor of the scaled matrix.
  std::array<std::array<double, n>, n> factor{};
  std::array<double, n> white{};
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double scale_i = std::sqrt(covariance[i * n + i]);
    for (std::size_t j = 0; j <= i; ++j) {
      const double scale_j = std::sqrt(covariance[j * n + j]);
      double left = covariance[i * n + j] / (scale_i * scale_j);
      for (std::size_t k = 0; k < j; ++k) left -= factor[i][k] * factor[j][k];
      factor[i][j] = i == j ? std::sqrt(left) : left / factor[j][j];
    }
    double left = difference[i] / scale_i;
    for (std::size_t k = 0; k < i; ++k) left -= factor[i][k] * white[k];
    white[i] = left / factor[i][i];
    sum += white[i] * white[i];
  }
  return sum;
}

}  // namespace runmark::test
