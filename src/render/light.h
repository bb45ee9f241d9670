#pragma once

#include <cstdint>
#include <vector>

#include "render/plane.h"
#include "runmark/marker.h"

namespace runmark::render {

/// Something that keeps `depth` (0 to 1) of the light off part of the picture. Places are in pixels.
struct Shadow {
  enum class Shape : std::uint8_t {
    edge,    ///< everything on one side of a line
    band,    ///< a strip `size` wide along a line
    blinds,  ///< strips `size` wide, `size` apart
    blob,    ///< a disc of radius `size`
  };
  Shape shape = Shape::edge;
  Point place;           ///< on the line, or the disc's centre
  double direction = 0;  ///< of the line's normal, radians
  double size = 100;
  double softness = 1;  ///< half the width of the penumbra
  double depth = 0.5;
};

/// A lamp's patch of light: adds `strength` at its centre, half of it `reach` pixels away.
struct Lamp {
  Point place;
  double strength = 0.5;
  double reach = 200;
};

/// How much light falls where. It multiplies what the surfaces return.
struct Light {
  double level = 0.9;   ///< at the picture's centre; 1 makes a perfect white full scale
  double slope_x = 0;   ///< share of the level gained from the centre to the right edge
  double slope_y = 0;   ///< and to the lower edge
  double vignette = 0;  ///< share lost in the corners
  std::vector<Lamp> lamps;
  std::vector<Shadow> shadows;

  /// The light at a place of a picture of that size.
  [[nodiscard]] double at(Point p, int width, int height) const;
};

/// Multiplies the picture by the light.
void shine(Plane& picture, const Light& light);

}  // namespace runmark::render
