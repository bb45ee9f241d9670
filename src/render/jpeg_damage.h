#pragma once

#include <cstdint>
#include <span>

namespace runmark::render {

/// What JPEG compression at `quality` (1 to 100) and decompression leave of a grey picture: 8x8 blocks
/// through the discrete cosine transform, divided by the luminance table of ITU-T T.81 Annex K scaled as
/// libjpeg scales it, rounded, and back. Done here so that every machine gets the same picture.
void damage_as_jpeg(std::span<std::uint8_t> grey, int width, int height, int quality);

}  // namespace runmark::render
