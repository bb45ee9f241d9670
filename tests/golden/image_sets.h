#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "evaluate/truth.h"
#include "runmark/dictionary.h"

namespace runmark::golden {

/// An image with its truth, and what is to be looked for in it.
struct LabelledImage {
  cv::Mat grey;
  TruthImage truth;
  std::vector<Dictionary> dictionaries;
};

/// The first scenes of a standard set, rendered now.
[[nodiscard]] std::vector<LabelledImage> rendered_scenes(const std::string& set, int scenes);

/// The real photos beside the repository (RUNMARK_SHARED says where else); none when they are not there.
[[nodiscard]] std::vector<LabelledImage> photos();

/// The same image and truth after so many quarter turns clockwise.
[[nodiscard]] LabelledImage turned(const LabelledImage& image, int quarters);

/// Where the shared files would be.
[[nodiscard]] std::string shared_folder();

}  // namespace runmark::golden
