#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "stage_trace.h"
#include "threshold/fixed_threshold.h"

namespace runmark::cli {

/// The paper's square grid on the first edge of a quadrilateral; nothing when it leaves the picture.
[[nodiscard]] std::optional<SampleGrid> paper_grid(const cv::Mat& grey, const Quad& quad,
                                                   const FixedThreshold& threshold);

/// The middles of a marker's cells by the homography of its four corners, data cells beyond the square
/// included; nothing when the quadrilateral has no marker's border.
[[nodiscard]] std::optional<SampleGrid> cell_grid(const cv::Mat& grey, const Quad& quad,
                                                  const Dictionary& dictionary);

}  // namespace runmark::cli
