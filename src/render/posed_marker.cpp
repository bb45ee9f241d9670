#include "render/posed_marker.h"

#include <algorithm>

#include "render/maths.h"
#include "render/placement.h"
#include "runmark/marker_grid.h"

namespace runmark::render {
namespace {

// A number between 0 and 1, the lower ones more often.
double skewed(Rng& rng, int powers) {
  const double x = rng.uniform();
  double y = x;
  for (int i = 1; i < powers; ++i) y *= x;
  return y;
}

}  // namespace

Scene posed_marker(const Dictionary& dictionary, const PosedMarkerRanges& ranges, Rng& rng) {
  const double size = exponential(rng.uniform(logarithm(ranges.smallest), logarithm(ranges.largest)));
  const int side = std::clamp(static_cast<int>(1.9 * size) + 40, 96, 512);
  const double middle = (side - 1) / 2.0;
  Scene scene;
  scene.dictionary = dictionary.name;
  scene.camera = {side, side, 700, 0};
  scene.light.level = rng.uniform(0.4, 1);
  scene.light.slope_x = rng.uniform(-0.2, 0.2);
  scene.light.slope_y = rng.uniform(-0.2, 0.2);
  scene.optics.defocus = rng.chance(0.4) ? Optics::Defocus::disc : Optics::Defocus::gaussian;
  scene.optics.blur = 0.3 + (ranges.most_blur - 0.3) * skewed(rng, 3);
  scene.optics.motion = rng.chance(ranges.motion) ? rng.uniform(1, 4) : 0;
  scene.optics.motion_direction = rng.uniform(0, pi);
  scene.sensor.noise = 0.5 + (ranges.most_noise - 0.5) * skewed(rng, 2);
  scene.sensor.jpeg = rng.chance(ranges.jpeg) ? static_cast<int>(rng.uniform(60, 95)) : 0;
  scene.sensor.seed = rng.next();

  const auto wall_shade = static_cast<float>(rng.uniform(0.2, 0.7));
  scene.surfaces.push_back({stand(scene.camera, {{middle, middle}, 50, 0, 0, 0}, 1, 0, 0),
                            {-100, -100, 100, 100},
                            Gradient{wall_shade, wall_shade}});
  const auto black = static_cast<float>(rng.uniform(0.04, 0.2));
  const auto white = static_cast<float>(rng.uniform(0.7, 0.95));
  const int id = rng.below(static_cast<int>(dictionary.codes.size()));
  const double width = dictionary.width;
  const MarkerGrid grid = marker_grid(dictionary, static_cast<std::size_t>(id));
  const double low = grid.first - rng.uniform(0.8, 2.5);
  Surface marker;
  marker.extent = {low, low, width - low, width - low};
  marker.texture = MarkerPrint{grid, black, white, false};
  const Stance stance{{middle + rng.uniform(-3, 3), middle + rng.uniform(-3, 3)},
                      rng.uniform(6, 20),
                      radians(rng.uniform(0, ranges.most_tilt)),
                      rng.uniform(0, 2 * pi),
                      rng.uniform(0, 2 * pi)};
  marker.pose = stand_to_size(scene.camera, stance, size, {0, 0, width, width});
  scene.surfaces.push_back(marker);
  scene.markers = {{1, id, dictionary.width}};
  return scene;
}

}  // namespace runmark::render
