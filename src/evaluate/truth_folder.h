#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/truth.h"
#include "runmark/dictionary.h"

namespace runmark {

/// Looked for in images that have no marker: a set in which false alarms are as likely as people meet
/// them, from 4x4 to 6x6 cells.
inline const std::vector<std::string> dictionaries_without_markers{"DICT_4X4_50", "DICT_5X5_100",
                                                                   "DICT_6X6_250", "tag36h11"};

/// The folder a truth file lies in: where its images and its own dictionaries are.
class TruthFolder {
 public:
  /// @param images  the folder of the images; empty: "images" beside the truth file, or its own folder
  explicit TruthFolder(const std::filesystem::path& truth_file, std::filesystem::path images = {});

  [[nodiscard]] std::filesystem::path image(const TruthImage& image) const;

  /// The dictionaries to look for in that image: its own, built in or from "dictionaries/NAME.codes"
  /// ("custom:NAME" means the same), or `dictionaries_without_markers`.
  [[nodiscard]] Result<std::vector<Dictionary>> dictionaries(const TruthImage& image) const;

 private:
  std::filesystem::path folder_;
  std::filesystem::path images_;
};

}  // namespace runmark
