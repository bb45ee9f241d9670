#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace runmark::cli {

/// Writes a grey or BGR picture as PNG. Throws UserError.
void write_png(const std::string& path, const cv::Mat& picture);

}  // namespace runmark::cli
