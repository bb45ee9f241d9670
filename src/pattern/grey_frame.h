#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "threshold/grey.h"

namespace runmark {

/// The part of the grey frame that has come in: what the pattern core may read. Owns nothing.
struct GreyFrame {
  const std::uint8_t* const* rows = nullptr;  ///< first byte of each row
  int width = 0;
  int height = 0;  ///< rows that have come in; the last one stands in for those that have not
  int step = 1;
  PixelFormat format = PixelFormat::grey;

  [[nodiscard]] int at(int x, int y) const {
    return grey_of(rows[y] + static_cast<std::ptrdiff_t>(x) * step, format);
  }

  /// Bilinear grey level at a point in pixels; beyond the frame the nearest pixel counts.
  [[nodiscard]] float sample(float x, float y) const {
    x = std::clamp(x, 0.0F, static_cast<float>(width - 1));
    y = std::clamp(y, 0.0F, static_cast<float>(height - 1));
    const int x0 = std::min(static_cast<int>(x), std::max(width - 2, 0));
    const int y0 = std::min(static_cast<int>(y), std::max(height - 2, 0));
    const int x1 = std::min(x0 + 1, width - 1);
    const int y1 = std::min(y0 + 1, height - 1);
    const float fx = x - static_cast<float>(x0);
    const float fy = y - static_cast<float>(y0);
    const std::uint8_t* above = rows[y0] + static_cast<std::ptrdiff_t>(x0) * step;
    const std::uint8_t* below = rows[y1] + static_cast<std::ptrdiff_t>(x0) * step;
    const std::ptrdiff_t right = static_cast<std::ptrdiff_t>(x1 - x0) * step;
    const auto a = static_cast<float>(grey_of(above, format));
    const auto b = static_cast<float>(grey_of(above + right, format));
    const auto c = static_cast<float>(grey_of(below, format));
    const auto d = static_cast<float>(grey_of(below + right, format));
    const float upper = a + fx * (b - a);
    const float lower = c + fx * (d - c);
    return upper + fy * (lower - upper);
  }
};

}  // namespace runmark
