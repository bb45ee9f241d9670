#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "runmark/marker.h"

namespace runmark::cli {

/// A BGR copy of the picture with each marker's outline, its id, and a filled square on its first
/// corner (the top-left one of the marker as drawn). Lines and letters grow with the picture.
[[nodiscard]] cv::Mat annotate(const cv::Mat& picture, std::span<const Marker> markers);

}  // namespace runmark::cli
