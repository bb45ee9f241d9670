#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "frame.h"
#include "runmark/dictionary.h"
#include "runmark/marker.h"
#include "runmark/options.h"

namespace runmark::cli {

/// What can be looked at, by its key.
enum class Stage : char {
  original = '1',
  threshold = '2',
  preprocess = '3',
  contours = '4',
  corners = '5',
  grid = '6',
  markers = '7',
};

/// One of the first six: what a core makes of the frame.
[[nodiscard]] cv::Mat draw_stage(const Frame& frame, Stage stage, const Options& options,
                                 const std::vector<Dictionary>& dictionaries);

/// The picture as shown: not too small to read a line, with `status` below it and `lines` over it.
[[nodiscard]] cv::Mat compose(const cv::Mat& picture, const std::string& status,
                              std::span<const std::string> lines);

}  // namespace runmark::cli
