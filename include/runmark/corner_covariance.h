#pragma once

#include <array>

#include "runmark/export.h"
#include "runmark/image_view.h"
#include "runmark/marker.h"

namespace runmark {

/// Covariance of a marker's four corners, 8x8 row-major: x0 y0 x1 y1 x2 y2 x3 y3, in square pixels. Corners
/// lie where lines through the sides meet, so neighbours err together.
using CornerCovariance = std::array<double, 64>;

/// What is to be expected of a marker of this size and shape in an ordinary picture.
[[nodiscard]] RUNMARK_EXPORT CornerCovariance corner_covariance(const Marker& marker);

/// The same from the picture the marker was found in: how noisy it is and how steep and high the marker's
/// edges are. The picture must be the one the corners refer to.
[[nodiscard]] RUNMARK_EXPORT CornerCovariance corner_covariance(const Marker& marker,
                                                                const ImageView& picture);

}  // namespace runmark
