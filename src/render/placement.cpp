#include "render/placement.h"

#include <algorithm>
#include <cmath>

#include "render/maths.h"

namespace runmark::render {

PlanePose stand(const Camera& camera, const Stance& stance, double unit_length, double centre_u,
                double centre_v) {
  // A frame whose third axis is the line of sight.
  const Vec3 sight = unit(camera.ray(stance.place));
  const Vec3 right = unit(cross({0, 1, 0}, sight));
  const Vec3 down = cross(sight, right);
  // The axis the plane turns about lies across the direction it leans in.
  const double ca = cosine(stance.azimuth);
  const double sa = sine(stance.azimuth);
  const Vec3 lean = ca * right + sa * down;
  const Vec3 axis = -sa * right + ca * down;
  const Vec3 leaning = cosine(stance.tilt) * lean + sine(stance.tilt) * sight;
  // Undo the azimuth, so that it does not turn the thing, then spin.
  const double turn = stance.spin - stance.azimuth;
  const Vec3 u = cosine(turn) * leaning + sine(turn) * axis;
  const Vec3 v = -sine(turn) * leaning + cosine(turn) * axis;
  const Vec3 along_u = unit_length * u;
  const Vec3 along_v = unit_length * v;
  return {stance.distance * sight - centre_u * along_u - centre_v * along_v, along_u, along_v};
}

PlanePose stand_to_size(const Camera& camera, const Stance& stance, double size, const Rectangle& rectangle) {
  const double u = (rectangle.left + rectangle.right) / 2;
  const double v = (rectangle.top + rectangle.bottom) / 2;
  const double width = rectangle.right - rectangle.left;
  const double height = rectangle.bottom - rectangle.top;
  // Tilted things reach behind the camera when they are too large: grow towards the size from below.
  const double limit = 1.2 * stance.distance / std::max(width, height);
  double unit_length = std::min(limit, size * stance.distance / camera.focal / std::sqrt(width * height));
  PlanePose pose = stand(camera, stance, unit_length, u, v);
  for (int i = 0; i < 12; ++i) {
    const double got = std::sqrt(std::abs(area(camera.picture(pose, rectangle))));
    unit_length = std::min(limit, unit_length * std::clamp(size / got, 0.5, 2.0));
    pose = stand(camera, stance, unit_length, u, v);
  }
  return pose;
}

bool Taken::is_free(const Quad& quad) const {
  return std::none_of(quads_.begin(), quads_.end(), [&](const Quad& other) { return overlap(quad, other); });
}

bool within(const Quad& quad, int width, int height, double inset) {
  return std::all_of(quad.begin(), quad.end(), [&](Point p) {
    return p.x >= inset && p.y >= inset && p.x <= width - 1 - inset && p.y <= height - 1 - inset;
  });
}

}  // namespace runmark::render
