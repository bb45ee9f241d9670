#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runmark/dictionary.h"

namespace runmark {

/// Where cell `c` of a square `width` cells wide goes when the square is turned 90 degrees clockwise.
[[nodiscard]] constexpr Cell turned_clockwise(Cell c, int width) {
  return {static_cast<std::int8_t>(width - 1 - c.y), c.x};
}

/// Turns codes, by tables of four bits each (2 KB). For cells that map onto themselves under rotation;
/// what lies outside of them is lost.
class CellRotation {
 public:
  /// Of 64 cells at most.
  CellRotation(std::span<const Cell> cells, int width);

  /// `sampled` holds the cells of a grid in which the marker appears turned 90 degrees clockwise: the
  /// marker's own code. Applied r times it undoes r turns.
  [[nodiscard]] std::uint64_t turned_back(std::uint64_t sampled) const {
    std::uint64_t code = 0;
    for (std::size_t i = 0; i < used_; ++i) {
      code |= tables_[i][sampled & 15U];
      sampled >>= 4U;
    }
    return code;
  }

  /// True when some rotation of `code` other than none is `code`: its orientation cannot be told.
  [[nodiscard]] bool is_own(std::uint64_t code) const {
    return turned_back(turned_back(code)) == code;  // equal after a quarter turn implies after a half turn
  }

 private:
  std::size_t used_ = 0;
  std::array<std::array<std::uint64_t, 16>, 16> tables_{};
};

}  // namespace runmark
