#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/corners.h"
#include "runmark/result.h"

namespace runmark {

/// A marker that is known to be in an image.
struct TruthMarker {
  int id = -1;
  Corners corners{};
  bool exact_corners = false;        ///< good enough to measure corner errors against
  std::optional<double> tilt{};      ///< degrees between the marker's normal and the line of sight
  std::optional<double> blur{};      ///< standard deviation of the defocus, in pixels
  std::optional<double> motion{};    ///< length of the motion blur, in pixels
  std::optional<double> noise{};     ///< standard deviation, in grey levels
  std::optional<double> contrast{};  ///< white minus black, in grey levels
};

/// What is known of an image.
struct TruthImage {
  std::string image{};                      ///< file name, or path below the folder of images
  int width = 0;                            ///< pixels
  int height = 0;                           ///< pixels
  std::optional<std::string> dictionary{};  ///< none: there is no marker in the image
  bool inverted = false;                    ///< white on black
  std::vector<TruthMarker> markers{};
  std::vector<TruthMarker> maybe{};  ///< doubtful ones: neither rewarded nor punished
  std::vector<int> present_ids{};    ///< ids that are on the target; any other is a false alarm
  bool rendered = false;
  std::string source{};
};

/// Reads a truth file: a JSON array of images, see docs/evaluation.md. Errors name the file, the image
/// and the member.
[[nodiscard]] Result<std::vector<TruthImage>> read_truth(const std::filesystem::path& file);

}  // namespace runmark
