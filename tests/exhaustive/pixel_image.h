#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace runmark {

/// A binary image as the tests see it: one byte a pixel, light outside.
class PixelImage {
 public:
  PixelImage(int width, int height) { resize(width, height); }

  /// A light image of that size.
  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    dark_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool dark(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ && dark_[index(x, y)] != 0;
  }
  void set(int x, int y, bool dark) { dark_[index(x, y)] = dark ? 1 : 0; }

  /// Image number `bits` of all of this size: pixel (x, y) is bit y * width + x.
  void set_all(std::uint64_t bits) {
    for (std::uint8_t& pixel : dark_) {
      pixel = bits & 1U;
      bits >>= 1;
    }
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> dark_;
};

}  // namespace runmark
