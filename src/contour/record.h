#pragma once

#include <cstdint>

namespace runmark {

/// Index of a record in the pool; no_record ends a list.
using RecordIndex = std::uint16_t;
inline constexpr RecordIndex no_record = 0xFFFF;

/// One horizontal crack run of a chain (the paper's run-length link). The boundary is followed with the
/// dark pixels on its right hand, so outer contours go clockwise in the image: it arrives on crack line
/// `y` (the line above pixel row y), follows it and leaves it at crack `x`, up or down to the next
/// record's line. Vertical cracks need no record: they join (x, y) to (x, next.y).
struct Record {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  RecordIndex next = no_record;
};

}  // namespace runmark
