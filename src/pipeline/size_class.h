#pragma once

#include <algorithm>
#include <bit>

namespace runmark {

/// The side a detector is made for that is to take frames of this side and the like: the next power of two.
/// What a frame gives then does not depend on the frames before it.
[[nodiscard]] constexpr int size_class(int side) {
  constexpr int most_side = 65535;
  return std::min(static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(side, 1)))), most_side);
}

}  // namespace runmark
