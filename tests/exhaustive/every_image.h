#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "contour_checker.h"

namespace runmark {

/// What to run every image of a size through.
struct ProofScope {
  bool four = true;
  bool eight = true;
  bool unfiltered = true;
  bool filtered = true;  ///< with every case on
  bool limits = true;    ///< with limits that drop contours, early and not, and with too few records
  int column = 0;        ///< where the image stands in its rows
  /// Leave out images whose first or last row or column is all light: without it they are an image of a
  /// smaller shape, which another run checks.
  bool smaller_left_out = false;
};

/// What is wrong with one image, or nullptr: all runs of the scope.
[[nodiscard]] const char* check_image(ContourChecker& checker, const PixelImage& image,
                                      const ProofScope& scope);

struct ProofResult {
  std::uint64_t images = 0;
  std::uint64_t wrong = 0;
  std::uint64_t first_wrong = 0;  ///< number of that image (PixelImage::set_all)
  const char* first_fault = nullptr;
};

/// Checks every image of width * height pixels, at most 32. Images left out count as images.
[[nodiscard]] ProofResult check_every_image(int width, int height, int threads, const ProofScope& scope);

}  // namespace runmark
