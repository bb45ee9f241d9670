#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "evaluate/corners.h"

namespace runmark::bench {

/// The surroundings of a marker with its outline drawn (first corner as a dot), as a data: URI.
/// Empty when nothing of it lies in the image.
[[nodiscard]] std::string thumbnail(const cv::Mat& grey, const Corners& corners, const cv::Scalar& colour);

}  // namespace runmark::bench
