#pragma once

#include <vector>

namespace runmark {

/// A PNG file with the number of pixels an inch noted in it (chunk pHYs), so that programs print it at true
/// size; cairo does not do that.
[[nodiscard]] std::vector<unsigned char> with_resolution(const std::vector<unsigned char>& png, int dpi);

}  // namespace runmark
