#pragma once

#include "render/geometry.h"
#include "render/texture.h"

namespace runmark::render {

/// A flat thing in the scene. Later surfaces of a scene hide earlier ones.
struct Surface {
  PlanePose pose;
  Rectangle extent;  ///< in plane coordinates
  Texture texture;
  float shade = 1;     ///< share of the light it gets by the way it faces
  bool paper = false;  ///< in colour pictures: nearly neutral
};

}  // namespace runmark::render
