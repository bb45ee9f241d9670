#pragma once

namespace runmark {

/// A step from -1 to 1 blurred by a Gaussian, and its derivatives.
struct BlurredStep {
  double value;
  double by_distance;
  double by_width;
};

/// @param distance  from the step, in pixels
/// @param width     standard deviation of the blur, in pixels; positive
[[nodiscard]] BlurredStep blurred_step(double distance, double width);

}  // namespace runmark
