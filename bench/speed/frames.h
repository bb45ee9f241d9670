#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "runmark/dictionary.h"
#include "runmark/result.h"

namespace runmark::bench {

/// A picture to be timed on, and what is to be looked for in it.
struct TimedFrame {
  cv::Mat grey;
  std::vector<Dictionary> dictionaries;
  bool inverted = false;
  int markers = 0;
};

struct FrameSet {
  std::string name;  ///< "1920x1080", or "photos"
  std::vector<TimedFrame> frames;
  [[nodiscard]] double markers_per_frame() const;
};

/// So many scenes of a standard set from number `first` on, rendered now; tag36h11.
[[nodiscard]] Result<FrameSet> standard_frames(const std::string& set, int scenes, int first = 0);

/// The images of a truth file, `count` of them spread evenly.
[[nodiscard]] Result<FrameSet> photo_frames(const std::filesystem::path& truth, int count);

}  // namespace runmark::bench
