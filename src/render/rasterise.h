#pragma once

#include "render/camera.h"
#include "render/plane.h"
#include "render/surface.h"

namespace runmark::render {

/// Paints a surface over the picture (camera.width x camera.height). Each pixel is the mean over its
/// square: 8 x 8 samples wherever an edge of a marker or the outline of a surface crosses it (the rows and
/// columns of samples are sheared, so that an upright edge meets 64 different places and not 8), fewer
/// inside clutter, and one where the surface is plain.
void paint(Plane& picture, const Camera& camera, const Surface& surface);

}  // namespace runmark::render
