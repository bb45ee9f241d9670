#include "render/board_scene.h"

#include <algorithm>
#include <cmath>

#include "render/draw_light.h"
#include "render/maths.h"
#include "render/place_board.h"
#include "render/placement.h"

namespace runmark::render {

BoardScene make_board_scene(const Recipe& recipe, const Board& board, const Dictionary& dictionary,
                            std::uint64_t seed, int index) {
  Rng of_camera(mix(seed));
  Rng rng(mix(seed ^ mix(static_cast<std::uint64_t>(index) + 1)));
  BoardScene made;
  Scene& scene = made.scene;
  scene.dictionary = dictionary.name;
  scene.inverted = recipe.inverted;
  scene.camera = {recipe.width, recipe.height, recipe.width * recipe.focal.draw(of_camera),
                  recipe.distortion.draw(of_camera)};
  scene.light = draw_light(recipe, rng);
  scene.optics.blur = recipe.blur.draw(rng);
  scene.optics.motion = recipe.motion.draw(rng);
  scene.optics.motion_direction = rng.uniform(0, pi);
  scene.sensor = {recipe.noise.draw(rng), recipe.gamma, static_cast<int>(recipe.jpeg.draw(rng)), rng.next()};
  scene.tints = scene.sensor.seed;
  scene.background = "plain";

  double right = 0;
  double bottom = 0;
  for (const BoardMarker& marker : board.markers) {
    for (const Point3& p : marker.corners) {
      right = std::max(right, p.x);
      bottom = std::max(bottom, p.y);
    }
  }
  if (board.charuco) {
    right = board.charuco->columns * board.charuco->square;
    bottom = board.charuco->rows * board.charuco->square;
  }
  const double w = recipe.width;
  const double h = recipe.height;
  // By the longer side, so that narrow boards fit, too.
  const double longer = rng.uniform(0.45, 0.85) * std::min(w, h);
  const double size = longer * std::sqrt(std::min(right, bottom) / std::max(right, bottom));
  Stance stance;
  stance.place = {rng.uniform(0.25, 0.75) * w, rng.uniform(0.25, 0.75) * h};
  stance.distance = 1;
  stance.tilt = radians(recipe.tilt.draw(rng));
  stance.azimuth = rng.uniform(0, 2 * pi);
  stance.spin = rng.chance(0.7) ? rng.uniform(-0.4, 0.4) : rng.uniform(0, 2 * pi);
  PlanePose plane = stand_to_size(scene.camera, stance, size, {0, 0, right, bottom});
  // The board's unit is 1: what looks alike at another scale is put farther off.
  const double unit = std::sqrt(dot(plane.along_u, plane.along_u));
  plane = {(1 / unit) * plane.origin, (1 / unit) * plane.along_u, (1 / unit) * plane.along_v};
  made.plane = plane;

  const double far = 4 * std::sqrt(dot(plane.origin, plane.origin)) + 4 * std::max(right, bottom);
  const auto shade = static_cast<float>(rng.uniform(0.25, 0.6));
  Surface wall;
  wall.pose = stand(scene.camera, {{(w - 1) / 2, (h - 1) / 2}, far, 0, 0, 0}, 1, 0, 0);
  wall.extent = {-4 * far, -4 * far, 4 * far, 4 * far};
  wall.texture = Gradient{shade, shade};
  scene.surfaces.push_back(wall);
  BoardPrint print;
  print.inverted = recipe.inverted;
  place_board(scene, board, dictionary, plane, print);
  return made;
}

}  // namespace runmark::render
