#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "stage_trace.h"

namespace runmark::cli {

/// One stage as a BGR picture.
struct StagePicture {
  std::string name;     ///< of its file, without extension
  std::string caption;  ///< one line
  cv::Mat picture;
  bool on_sheet = true;
};

/// The pictures of all stages, in the order of the cores.
[[nodiscard]] std::vector<StagePicture> draw_stages(const StageTrace& trace);

/// All stages with their captions on one sheet (the paper's Fig. 6).
[[nodiscard]] cv::Mat draw_sheet(const std::vector<StagePicture>& pictures, const StageTrace& trace,
                                 const std::string& title);

}  // namespace runmark::cli
