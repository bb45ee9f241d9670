#include "render/camera_path.h"

#include "render/maths.h"
#include "render/rng.h"

namespace runmark::render {

namespace {

struct Motion {
  double yaw = 0;
  double pitch = 0;
  double roll = 0;
  Vec3 shift;

  // What the camera sees in direction v when it has turned so.
  [[nodiscard]] Vec3 turned(Vec3 v) const {
    v = {cosine(yaw) * v.x - sine(yaw) * v.z, v.y, sine(yaw) * v.x + cosine(yaw) * v.z};
    v = {v.x, cosine(pitch) * v.y - sine(pitch) * v.z, sine(pitch) * v.y + cosine(pitch) * v.z};
    return {cosine(roll) * v.x - sine(roll) * v.y, sine(roll) * v.x + cosine(roll) * v.y, v.z};
  }
};

}  // namespace

Scene after(const Scene& scene, double seconds, double strength) {
  // Sines of periods that share no multiple; all of them 0 at the start.
  const auto sway = [&](double degrees_or_length, double period) {
    return strength * degrees_or_length * sine(2 * pi * seconds / period);
  };
  Motion motion;
  motion.yaw = radians(sway(6, 4.1));
  motion.pitch = radians(sway(4, 3.3));
  motion.roll = radians(sway(5, 5.7));
  motion.shift = {sway(0.6, 4.7), sway(0.4, 3.7), sway(1.2, 6.1)};

  Scene later = scene;
  for (Surface& surface : later.surfaces) {
    surface.pose.origin = motion.turned(surface.pose.origin - motion.shift);
    surface.pose.along_u = motion.turned(surface.pose.along_u);
    surface.pose.along_v = motion.turned(surface.pose.along_v);
  }
  // Lamps and shadows lie on the wall: they go where it goes.
  constexpr double wall = 30;
  const auto follow = [&](Point& place) {
    const Vec3 p = motion.turned(wall * scene.camera.ray(place) - motion.shift);
    if (p.z <= 0) return;
    place = scene.camera.distort({scene.camera.centre_x() + scene.camera.focal * p.x / p.z,
                                  scene.camera.centre_y() + scene.camera.focal * p.y / p.z});
  };
  for (Lamp& lamp : later.light.lamps) follow(lamp.place);
  for (Shadow& shadow : later.light.shadows) {
    follow(shadow.place);
    shadow.direction += motion.roll;
  }
  later.sensor.seed = mix(scene.sensor.seed + static_cast<std::uint64_t>(seconds * 1e6));
  return later;
}

}  // namespace runmark::render
