#pragma once

#include "runmark/camera.h"

namespace runmark {

/// A direction (x, y, 1) after the lens, and how it moves with the direction: [dx/dx, dx/dy, dy/dx, dy/dy].
struct Bent {
  Point at;
  std::array<double, 4> by{1, 0, 0, 1};
};

/// Source of the models: OpenCV's documentation of calib3d and of its fisheye module.
[[nodiscard]] Bent bend(const Camera& camera, Point direction);

}  // namespace runmark
