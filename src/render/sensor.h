#pragma once

#include <cstdint>
#include <vector>

#include "render/plane.h"

namespace runmark::render {

/// From light to grey levels.
struct Sensor {
  double noise = 0;  ///< standard deviation at level 128 before the tone curve, grey levels: half of its
                     ///< square is the same everywhere (read), half goes with the light (shot)
  double gamma = 1;  ///< tone curve: level = light to the power 1 / gamma. Above 1, blurred edges move
                     ///< into the dark side, as they do in photos
  int jpeg = 0;      ///< quality 1 to 100 of the compression the picture has been through; 0 for none
  std::uint64_t seed = 0;
};

/// Reads the picture out: width * height grey levels, row-major.
[[nodiscard]] std::vector<std::uint8_t> expose(const Plane& picture, const Sensor& sensor);

}  // namespace runmark::render
