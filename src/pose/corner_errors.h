#pragma once

#include <array>

#include "runmark/corner_covariance.h"

namespace runmark {

/// How far off a marker's corners are to be expected, in pixels.
struct CornerErrors {
  /// Standard deviation of the line fitted to each side, at its middle and across it: upper, right, lower,
  /// left.
  std::array<double, 4> sides{};
  double common =
      0;  ///< of all four outwards or inwards together: blur joins the border to what is beside it
};

/// The covariance of the places where the lines meet. The corners must be those of a convex quadrilateral.
[[nodiscard]] CornerCovariance covariance_of(const std::array<Point, 4>& corners, const CornerErrors& errors);

}  // namespace runmark
