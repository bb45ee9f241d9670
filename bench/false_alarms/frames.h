#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string_view>

namespace runmark::bench {

/// What a frame without any marker is made of.
enum class FrameKind : std::uint8_t { noise, texture, text };
inline constexpr int frame_kinds = 3;
[[nodiscard]] std::string_view name_of(FrameKind kind);
[[nodiscard]] inline FrameKind kind_of(int index) { return static_cast<FrameKind>(index % frame_kinds); }

/// Frame number `index`, 320x240, 8 bits grey: a function of the index alone, the kinds taking turns. Noise
/// is white, blurred or in blocks; textures are chequers, bricks, waves and heaps of rectangles; text runs
/// over the frame in lines of any font, size and angle. Contrast, blur and sensor noise vary.
[[nodiscard]] cv::Mat marker_free_frame(int index);

}  // namespace runmark::bench
