#pragma once

#include <cstdint>
#include <vector>

#include "render/scene.h"

namespace runmark::render {

/// The rendered frame in colour: width * height pixels of B, G, R. Each surface gets a tint of its own; paper
/// with markers stays nearly neutral. Grey made from it by (77 R + 150 G + 29 B + 128) / 256 is the frame's
/// own to within a level or two, except where a colour would not fit into a byte.
[[nodiscard]] std::vector<std::uint8_t> colourise(const Scene& scene, const RenderedFrame& frame);

}  // namespace runmark::render
