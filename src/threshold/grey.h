#pragma once

#include <cstdint>

#include "runmark/image_view.h"

namespace runmark {

/// The one grey formula of all forms of the cores: Rec. 601 weights in 1/256, rounded.
[[nodiscard]] constexpr std::uint8_t grey_of(unsigned red, unsigned green, unsigned blue) {
  return static_cast<std::uint8_t>((77 * red + 150 * green + 29 * blue + 128) >> 8);
}

/// Grey level of the pixel whose first byte is `pixel`.
[[nodiscard]] constexpr std::uint8_t grey_of(const std::uint8_t* pixel, PixelFormat format) {
  if (format == PixelFormat::grey) return *pixel;
  const bool rgb = format == PixelFormat::rgb;
  return grey_of(pixel[rgb ? 0 : 2], pixel[1], pixel[rgb ? 2 : 0]);
}

/// Writes a row of `width` pixels, `step` bytes apart, as grey bytes side by side.
void grey_row(const std::uint8_t* pixels, int width, int step, PixelFormat format, std::uint8_t* grey);

}  // namespace runmark
