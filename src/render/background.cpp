#include "render/background.h"

#include <algorithm>
#include <array>

#include "render/maths.h"
#include "render/placement.h"

namespace runmark::render {

namespace {

constexpr double wall_distance = 30;

std::uint32_t any_seed(Rng& rng) { return static_cast<std::uint32_t>(rng.next() >> 32U); }
float any_shade(Rng& rng, double low, double high) { return static_cast<float>(rng.uniform(low, high)); }

// Units of the wall: the distance to it, so that a picture is about one unit wide.
Texture wall_texture(Wall wall, Rng& rng) {
  const float mid = any_shade(rng, 0.15, 0.85);
  const auto around = [&](float spread) { return std::array{std::max(0.02F, mid - spread), mid + spread}; };
  switch (wall) {
    case Wall::gradient:
      return Gradient{any_shade(rng, 0.1, 0.7), any_shade(rng, 0.1, 0.7)};
    case Wall::noise: {
      const auto [a, b] = around(any_shade(rng, 0.05, 0.25));
      return Noise{a, b, rng.uniform(0.02, 0.3), 4, any_seed(rng)};
    }
    case Wall::foliage:
      return Noise{0.0F, any_shade(rng, 0.4, 0.9), rng.uniform(0.015, 0.06), 5, any_seed(rng)};
    case Wall::brick:
      return Brick{any_shade(rng, 0.2, 0.5), any_shade(rng, 0.3, 0.8), rng.uniform(0.025, 0.08),
                   any_seed(rng)};
    case Wall::wood:
      return Wood{any_shade(rng, 0.08, 0.3), any_shade(rng, 0.35, 0.65), rng.uniform(0.06, 0.25),
                  any_seed(rng)};
    case Wall::tiles:
      return Checker{any_shade(rng, 0.1, 0.5), any_shade(rng, 0.4, 0.8), rng.uniform(0.05, 0.15),
                     rng.uniform(0.03, 0.08)};
    case Wall::checker:
      return Checker{any_shade(rng, 0.05, 0.3), any_shade(rng, 0.4, 0.85), rng.uniform(0.02, 0.12), 0};
    default: {
      const auto [a, b] = around(any_shade(rng, 0.005, 0.05));
      return Noise{a, b, rng.uniform(0.01, 0.2), 3, any_seed(rng)};
    }
  }
}

const char* name_of(Wall wall) {
  switch (wall) {
    case Wall::gradient:
      return "gradient";
    case Wall::noise:
      return "noise";
    case Wall::foliage:
      return "foliage";
    case Wall::brick:
      return "brick";
    case Wall::wood:
      return "wood";
    case Wall::tiles:
      return "tiles";
    case Wall::checker:
      return "checker";
    case Wall::photo:
      return "photo";
    default:
      return "plaster";
  }
}

Wall any_wall(Rng& rng) {
  constexpr std::array walls{Wall::plaster, Wall::plaster, Wall::plaster, Wall::gradient,
                             Wall::noise,   Wall::foliage, Wall::brick,   Wall::wood,
                             Wall::wood,    Wall::tiles,   Wall::checker};
  return walls[static_cast<std::size_t>(rng.below(static_cast<int>(walls.size())))];
}

// Units: the thing's width.
Texture thing(Rng& rng) {
  const float dark = any_shade(rng, 0.03, 0.3);
  const float light = any_shade(rng, 0.45, 0.9);
  switch (rng.below(12)) {
    case 0:
      return Gradient{any_shade(rng, 0.05, 0.9), any_shade(rng, 0.05, 0.9)};
    case 1:
      return Noise{dark, light, rng.uniform(0.05, 0.4), 4, any_seed(rng)};
    case 2:
      return Checker{dark, light, 1.0 / (3 + rng.below(8)), 0};
    case 3:
      return Brick{dark, light, rng.uniform(0.04, 0.15), any_seed(rng)};
    case 4:
      return Wood{dark, light, rng.uniform(0.2, 0.6), any_seed(rng)};
    case 5:
      return Text{light, dark, rng.uniform(0.03, 0.12), any_seed(rng)};
    case 6:
      return Text{dark, light, rng.uniform(0.05, 0.2), any_seed(rng)};
    case 7:
      return Stripes{dark, light, rng.uniform(0.02, 0.15), any_seed(rng)};
    case 8:
      return Cells{dark * 0.5F, light, 4 + rng.below(22), rng.chance(0.5), any_seed(rng)};
    case 9:
      return Panes{light, dark, 1 + rng.below(3), 1 + rng.below(3), rng.uniform(0.04, 0.12)};
    case 10:
      return Panes{dark, light, 1 + rng.below(2), 1 + rng.below(2), rng.uniform(0.04, 0.15)};
    default:
      return Gradient{dark, dark};
  }
}

}  // namespace

std::string add_wall(Scene& scene, Wall wall, Rng& rng,
                     const std::vector<std::shared_ptr<const Plane>>& photos) {
  if (wall == Wall::any) wall = any_wall(rng);
  const Camera& camera = scene.camera;
  const Point centre{camera.centre_x(), camera.centre_y()};
  if (wall == Wall::photo && !photos.empty()) {
    // Fills the undistorted picture with some to spare.
    const auto& photo = photos[static_cast<std::size_t>(rng.below(static_cast<int>(photos.size())))];
    const double width = wall_distance * camera.width / camera.focal * 1.3;
    PlanePose pose = stand(camera, {centre, wall_distance}, 1, 0, 0);
    pose.along_u = width * pose.along_u;
    pose.along_v = (width * camera.height / camera.width) * pose.along_v;
    pose.origin = pose.at(-0.5, -0.5);
    scene.surfaces.push_back({pose, {0, 0, 1, 1}, Photo{photo}, 1, false});
    return "photo";
  }
  const double tilt = radians(rng.chance(0.5) ? rng.uniform(0, 10) : rng.uniform(10, 45));
  const Stance stance{centre, wall_distance, tilt, rng.uniform(0, 2 * pi), rng.uniform(-0.1, 0.1)};
  scene.surfaces.push_back(
      {stand(camera, stance, wall_distance, 0.5, 0.5), {-9, -9, 10, 10}, wall_texture(wall, rng), 1, false});
  // A floor or a table top, cut off by the wall.
  if (rng.chance(0.4)) {
    const double edge = rng.uniform(0.6, 0.95) * camera.height;
    const Stance floor{
        {centre.x, edge}, wall_distance, radians(rng.uniform(55, 75)), -pi / 2, rng.uniform(-0.1, 0.1)};
    Surface surface{stand(camera, floor, wall_distance, 0.5, 0),
                    {-9, 0, 10, 2},
                    wall_texture(any_wall(rng), rng),
                    1,
                    false};
    surface.shade = any_shade(rng, 0.5, 1);
    scene.surfaces.push_back(std::move(surface));
  }
  return name_of(wall);
}

void add_clutter(Scene& scene, int count, Rng& rng) {
  const Camera& camera = scene.camera;
  for (int i = 0; i < count; ++i) {
    const double aspect = rng.chance(0.4) ? 1 : rng.uniform(0.3, 2.0);
    // Sizes from a handful of pixels to half the picture, alike on every scale.
    const double size = camera.width * exponential(rng.uniform(-4.2, -0.8));
    Stance stance;
    stance.place = {rng.uniform(0, camera.width), rng.uniform(0, camera.height)};
    stance.distance = rng.uniform(15, 29);
    stance.tilt = radians(rng.chance(0.4) ? 5 : rng.uniform(0, 65));
    stance.azimuth = rng.uniform(0, 2 * pi);
    stance.spin = rng.chance(0.7) ? rng.uniform(-0.1, 0.1) : rng.uniform(0, 2 * pi);
    Surface surface;
    surface.extent = {0, 0, 1, aspect};
    surface.pose = stand_to_size(camera, stance, size, surface.extent);
    surface.texture = thing(rng);
    surface.shade = any_shade(rng, 0.6, 1.05);
    scene.surfaces.push_back(std::move(surface));
  }
}

}  // namespace runmark::render
