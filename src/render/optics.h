#pragma once

#include <cstdint>

#include "render/plane.h"

namespace runmark::render {

/// What spreads a point of light over several pixels. All of it is symmetric: no edge moves.
struct Optics {
  enum class Defocus : std::uint8_t { gaussian, disc };
  Defocus defocus = Defocus::gaussian;
  double blur = 0;              ///< standard deviation along one axis, pixels; a disc's radius is twice it
  double motion = 0;            ///< length of the path during the exposure, pixels
  double motion_direction = 0;  ///< radians
};

/// Blurs the picture; beyond its edges the outermost pixels go on.
void blur(Plane& picture, const Optics& optics);

}  // namespace runmark::render
