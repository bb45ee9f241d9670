#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "runmark/image_view.h"

namespace runmark::cli {

/// One frame and where it came from. Its pixels are 8 bits a channel, grey or BGR.
struct Frame {
  std::string source;      ///< the path as given or found, "-", or "camera:0"
  std::int64_t index = 0;  ///< counts from 0 within its source
  cv::Mat pixels;          ///< owns the memory `view()` looks at
  bool still = false;      ///< an image of its own, not one of many

  [[nodiscard]] ImageView view() const {
    const auto stride = static_cast<std::ptrdiff_t>(pixels.step[0]);
    return pixels.channels() == 1 ? ImageView::grey(pixels.data, pixels.cols, pixels.rows, stride)
                                  : ImageView::bgr(pixels.data, pixels.cols, pixels.rows, stride);
  }
};

}  // namespace runmark::cli
