#pragma once

#include <cstdint>

#include "preprocess/bit_row.h"

namespace runmark {

/// The paper's threshold: one level for the whole frame, set at run time.
struct FixedThreshold {
  int level = 128;             ///< 0 to 256
  bool above_is_dark = false;  ///< grey >= level is dark (as the paper prints it), else grey < level

  [[nodiscard]] constexpr bool dark(std::uint8_t grey) const { return (grey >= level) == above_is_dark; }
};

/// Turns `width` grey bytes into a bit row of bit_words(width) words.
void threshold_row(const std::uint8_t* grey, int width, const FixedThreshold& threshold, BitWord* bits);

}  // namespace runmark
