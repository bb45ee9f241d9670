#pragma once

#include <string>
#include <vector>

#include "detector_settings.h"
#include "pose_settings.h"

namespace runmark::cli {

struct ViewSettings {
  std::vector<std::string> inputs;
  DetectorSettings detector;
  PoseSettings poses;
  std::string screenshots = ".";
};

/// What the keys do, a line each.
inline constexpr const char* view_keys =
    "Keys: 1 original, 2 threshold, 3 preprocess, 4 contours, 5 corners, 6 sample grid, 7 markers;\n"
    "space pause and go on; n next image, or next frame while paused; m next input; b input before;\n"
    "a axes of poses; s screenshot; h help; q or Escape quit.";

/// Shows the inputs in a window until the person at it has seen enough. Throws UserError; ExitStatus when an
/// input was broken, after it was said.
void view(const ViewSettings& settings);

}  // namespace runmark::cli
