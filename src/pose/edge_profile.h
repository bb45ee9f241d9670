#pragma once

#include "pose/grey_sampler.h"
#include "runmark/marker.h"

namespace runmark {

/// The grey-level edge beneath a side of a marker.
struct EdgeProfile {
  double width = 0;    ///< standard deviation of its rise, in pixels
  double scatter = 0;  ///< of the places where lines across the side meet it, about a straight one, in pixels
};

/// @param reach  how far to look on both sides of the line from a to b, in pixels
[[nodiscard]] EdgeProfile edge_profile(const GreySampler& grey, Point a, Point b, double reach);

}  // namespace runmark
