#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "expect.h"

namespace runmark::fuzz {

/// Many gigabytes that can be read everywhere and cost one megabyte: the same pages over and over. What lies
/// before and behind cannot be touched, so that huge strides can be tried on real addresses.
class WideMemory {
 public:
  static constexpr std::size_t pattern = std::size_t{1} << 20U;
  static constexpr std::size_t size = std::size_t{8192} * pattern;

  WideMemory() {
    const int file = ::memfd_create("pixels", 0);
    expect(file >= 0 && ::ftruncate(file, pattern) == 0, "a megabyte can be had");
    // Guards of the same size on both sides.
    void* all =
        ::mmap(nullptr, size + 2 * pattern, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    expect(all != MAP_FAILED, "the addresses can be had");
    begin_ = static_cast<std::uint8_t*>(all) + pattern;
    for (std::size_t at = 0; at < size; at += pattern) {
      void* part = ::mmap(begin_ + at, pattern, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file, 0);
      expect(part != MAP_FAILED, "the pages can be mapped again");
    }
    ::close(file);
  }
  WideMemory(const WideMemory&) = delete;
  WideMemory& operator=(const WideMemory&) = delete;

  [[nodiscard]] std::uint8_t* begin() const { return begin_; }
  [[nodiscard]] std::uint8_t* end() const { return begin_ + size; }

  /// Fills all of it by saying `bytes` again and again.
  void fill(std::span<const std::uint8_t> bytes) {
    for (std::size_t at = 0; at < pattern; at += bytes.size()) {
      std::copy_n(bytes.data(), std::min(bytes.size(), pattern - at), begin_ + at);
    }
  }

 private:
  std::uint8_t* begin_ = nullptr;
};

}  // namespace runmark::fuzz
