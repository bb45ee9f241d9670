#pragma once

#include "render/maths.h"
#include "render/place_board.h"
#include "render/placement.h"
#include "render/scene.h"
#include "support/posed_scene.h"

namespace runmark::test {

/// A rendered board and the truth about it.
struct BoardScene {
  render::Scene scene;
  render::PlanePose plane;
  Pose pose;  ///< exact, in the board's unit
};

struct BoardStance {
  double size = 400;  ///< square root of the board's area in the picture, pixels
  double tilt = 0.5;  ///< radians
  double azimuth = 1;
  double spin = 0.2;
};

/// The board before a plain wall in a picture of 960x720, a little blurred and noisy.
inline BoardScene board_scene(const Board& board, const Dictionary& dictionary, const BoardStance& stance,
                              const render::BoardPrint& print = {}) {
  BoardScene made;
  render::Scene& scene = made.scene;
  scene.dictionary = dictionary.name;
  scene.camera = {960, 720, 900, 0};
  scene.light.level = 0.9;
  scene.optics.blur = 0.7;
  scene.sensor.noise = 2;
  scene.sensor.seed = 5;
  scene.surfaces.push_back({render::stand(scene.camera, {{480, 360}, 80, 0, 0, 0}, 1, 0, 0),
                            {-200, -200, 200, 200},
                            render::Gradient{0.45F, 0.45F}});
  double right = 0;
  double bottom = 0;
  for (const BoardMarker& marker : board.markers) {
    for (const Point3& p : marker.corners) {
      right = std::max(right, p.x);
      bottom = std::max(bottom, p.y);
    }
  }
  made.plane = render::stand_to_size(scene.camera, {{480, 360}, 12, stance.tilt, stance.azimuth, stance.spin},
                                     stance.size, {0, 0, right, bottom});
  render::place_board(scene, board, dictionary, made.plane, print);
  made.pose = pose_of(made.plane, 0, 0);
  const double unit = unit_of(made.plane);
  // In the board's own unit.
  made.pose.translation = {made.pose.translation.x / unit, made.pose.translation.y / unit,
                           made.pose.translation.z / unit};
  return made;
}

inline ImageView view_of(const render::RenderedFrame& frame) {
  return ImageView::grey(frame.grey.data(), frame.width, frame.height, frame.width);
}

}  // namespace runmark::test
