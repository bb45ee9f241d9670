#pragma once

#include <cstdint>

#include "contour/record.h"

namespace runmark {

/// Index of an open end in the linker's table.
using EndIndex = std::uint16_t;

/// One of the two open ends of a chain, standing on a vertical crack of the current row. The chain leaves
/// downwards at its down end (dark to the left of the crack), where records are appended, and comes up at
/// its up end (dark to the right), where they are prepended. Each end also counts its half of the chain.
struct ChainEnd {
  EndIndex partner = 0;            ///< the chain's other end; for a free entry, the next free one
  RecordIndex record = no_record;  ///< down end: last record of the list; up end: first
  std::uint32_t records = 0;       ///< counted at this end
  std::uint32_t turns = 0;         ///< starts and joins counted at this end
  std::uint16_t top = 0;           ///< least crack line of this half
  bool dead = false;               ///< the chain was given up: nothing but its cracks is followed
};

}  // namespace runmark
