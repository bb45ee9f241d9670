#include "boards/crossing_shape.h"

#include <algorithm>

#include "boards/blurred_step.h"

namespace runmark {

CrossingShape shape_of_crossing(double u, double v, double width, const CrossingDrawings& drawings) {
  const BlurredStep step_u = blurred_step(u, width);
  const BlurredStep step_v = blurred_step(v, width);
  CrossingShape shape{step_u.value * step_v.value, step_u.by_distance * step_v.value,
                      step_u.value * step_v.by_distance,
                      step_u.by_width * step_v.value + step_u.value * step_v.by_width};
  for (const double side_u : {-1.0, 1.0}) {
    const double side_v = drawings.on_diagonal ? side_u : -side_u;
    const double in_u = side_u * u - drawings.from_u;
    const double in_v = side_v * v - drawings.from_v;
    if (std::min(in_u, in_v) < -4 * width) continue;
    const BlurredStep a = blurred_step(in_u, width);
    const BlurredStep b = blurred_step(in_v, width);
    // Two times the product of steps from 0 to 1, towards the plain squares.
    const double sign = drawings.on_diagonal ? -0.5 : 0.5;
    shape.value += sign * (1 + a.value) * (1 + b.value);
    shape.by_u += sign * side_u * a.by_distance * (1 + b.value);
    shape.by_v += sign * side_v * (1 + a.value) * b.by_distance;
    shape.by_width += sign * (a.by_width * (1 + b.value) + (1 + a.value) * b.by_width);
  }
  return shape;
}

}  // namespace runmark
