#pragma once

#include <cstddef>
#include <cstdint>

#include "runmark/export.h"
#include "runmark/status.h"

namespace runmark {

/// How one pixel is stored. Colour becomes grey by one integer formula everywhere:
/// (77 R + 150 G + 29 B + 128) / 256.
enum class PixelFormat : std::uint8_t { grey, rgb, bgr };

/// A frame in the caller's memory: 8 bits a channel, any row stride, any pixel step, also negative ones and
/// those of a transposed picture. Owns nothing.
///
/// Pixel convention: the centre of the top-left pixel is (0, 0); x goes right, y goes down.
struct ImageView {
  const std::uint8_t* data = nullptr;  ///< first byte of the top-left pixel
  int width = 0;                       ///< pixels
  int height = 0;                      ///< pixels
  std::ptrdiff_t stride = 0;           ///< bytes from one row to the next; may be negative
  int step = 1;                        ///< bytes from one pixel to the next; may be negative
  PixelFormat format = PixelFormat::grey;

  /// One byte a pixel, `step` bytes apart (2 for the luma of YUYV, 1 for a plane).
  [[nodiscard]] static constexpr ImageView grey(const std::uint8_t* data, int width, int height,
                                                std::ptrdiff_t stride, int step = 1) {
    return {data, width, height, stride, step, PixelFormat::grey};
  }
  /// Three bytes a pixel in the order R, G, B, `step` bytes apart (4 for RGBA).
  [[nodiscard]] static constexpr ImageView rgb(const std::uint8_t* data, int width, int height,
                                               std::ptrdiff_t stride, int step = 3) {
    return {data, width, height, stride, step, PixelFormat::rgb};
  }
  /// Three bytes a pixel in the order B, G, R, `step` bytes apart (4 for BGRA).
  [[nodiscard]] static constexpr ImageView bgr(const std::uint8_t* data, int width, int height,
                                               std::ptrdiff_t stride, int step = 3) {
    return {data, width, height, stride, step, PixelFormat::bgr};
  }

  [[nodiscard]] constexpr const std::uint8_t* row(int y) const { return data + y * stride; }

  /// The rows [first, first + count) as a view of their own.
  [[nodiscard]] constexpr ImageView rows(int first, int count) const {
    return {row(first), width, count, stride, step, format};
  }

  /// Status::ok, or Status::bad_view when the fields contradict each other: no data, a side outside
  /// 1 to 65535, a step smaller than a pixel, or rows (and columns, if it is transposed) that overlap.
  [[nodiscard]] RUNMARK_EXPORT Status check() const;
};

}  // namespace runmark
