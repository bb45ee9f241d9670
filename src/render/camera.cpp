#include "render/camera.h"

#include <algorithm>
#include <cmath>

namespace runmark::render {

Point Camera::distort(Point p) const {
  const double dx = p.x - centre_x();
  const double dy = p.y - centre_y();
  const double r2 = (dx * dx + dy * dy) / reach2();
  // The root of distortion * s^2 * r2 - s + 1 = 0 that is 1 for no distortion.
  const double root = std::sqrt(std::max(0.0, 1 - 4 * distortion * r2));
  const double scale = 2 / (1 + root);
  return {centre_x() + dx * scale, centre_y() + dy * scale};
}

Homography Camera::project(const PlanePose& pose) const {
  Homography h;
  const auto column = [&](std::size_t i, Vec3 v) {
    h.m[i] = focal * v.x + centre_x() * v.z;
    h.m[i + 3] = focal * v.y + centre_y() * v.z;
    h.m[i + 6] = v.z;
  };
  column(0, pose.along_u);
  column(1, pose.along_v);
  column(2, pose.origin);
  return h;
}

Point Camera::picture(const PlanePose& pose, double u, double v) const {
  const Vec3 p = pose.at(u, v);
  return distort({centre_x() + focal * p.x / p.z, centre_y() + focal * p.y / p.z});
}

Quad Camera::picture(const PlanePose& pose, const Rectangle& r) const {
  return {picture(pose, r.left, r.top), picture(pose, r.right, r.top), picture(pose, r.right, r.bottom),
          picture(pose, r.left, r.bottom)};
}

}  // namespace runmark::render
