#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "pose_finder.h"
#include "runmark/marker.h"

namespace runmark::cli {

/// A BGR copy of the picture with each marker's outline, its id, and a filled square on its first
/// corner (the top-left one of the marker as drawn). Lines and letters grow with the picture.
[[nodiscard]] cv::Mat annotate(const cv::Mat& picture, std::span<const Marker> markers);

/// Draws an object's axes into an annotated picture: x red, y green, z blue.
void draw_axes(cv::Mat& picture, const AxesPicture& axes);

}  // namespace runmark::cli
