#pragma once

#include <vector>

#include "render/camera.h"
#include "render/geometry.h"
#include "render/rng.h"

namespace runmark::render {

/// How a flat thing stands before the camera.
struct Stance {
  Point place;  ///< of its centre in the picture
  double distance = 10;
  double tilt = 0;     ///< radians between its normal and the line of sight
  double azimuth = 0;  ///< radians: the direction in which it leans away
  double spin = 0;     ///< radians: turned in its own plane
};

/// The plane whose point (centre, centre) is seen at stance.place; its unit is `unit_length`.
[[nodiscard]] PlanePose stand(const Camera& camera, const Stance& stance, double unit_length, double centre_u,
                              double centre_v);

/// The same, with the unit chosen so that the rectangle's area in the picture is size * size.
[[nodiscard]] PlanePose stand_to_size(const Camera& camera, const Stance& stance, double size,
                                      const Rectangle& rectangle);

/// Keeps papers from covering each other.
class Taken {
 public:
  [[nodiscard]] bool is_free(const Quad& quad) const;
  void take(const Quad& quad) { quads_.push_back(quad); }

 private:
  std::vector<Quad> quads_;
};

/// Whether all corners are at least `inset` pixels inside the picture.
[[nodiscard]] bool within(const Quad& quad, int width, int height, double inset);

}  // namespace runmark::render
