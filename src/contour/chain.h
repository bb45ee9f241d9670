#pragma once

#include <cstddef>
#include <cstdint>

#include "contour/record_pool.h"

namespace runmark {

/// A closed contour as the linker hands it on. Valid only while it is being handed on: its records go
/// back to the pool afterwards. Its last record is the run that closed it, on its greatest crack line.
struct ClosedChain {
  const RecordPool* pool = nullptr;
  RecordIndex head = no_record;
  RecordIndex tail = no_record;
  std::uint32_t records = 0;  ///< horizontal runs; the polygon has twice as many corners
  std::uint32_t turns = 0;    ///< starts and joins: how often the boundary turns from up to down or back
  std::uint16_t top = 0;      ///< least crack line y
  std::uint16_t bottom = 0;   ///< greatest crack line y, where it closed
  bool hole = false;          ///< boundary of a light region inside dark; else of a dark region

  /// Calls visit(x_from, x_to, y) for every horizontal run in order; the vertical cracks between are at
  /// x_to of one run and x_from of the next. The first is the one after the closing run.
  template <class Visit>
  void runs(Visit&& visit) const {
    std::uint16_t x = (*pool)[tail].x;
    for (RecordIndex i = head; i != no_record; i = (*pool)[i].next) {
      const Record& record = (*pool)[i];
      visit(x, record.x, record.y);
      x = record.x;
    }
  }
};

/// Which contours the linker drops. Each rule is monotone (a chain that breaks it cannot be mended by
/// later rows), so what is dropped does not depend on when a chain is looked at.
struct ChainLimits {
  std::uint32_t max_turns = 30;
  std::uint32_t max_records = 4096;
  std::uint16_t min_height = 0;  ///< crack lines from top to bottom; tested on closing
  bool holes = true;             ///< hand on boundaries of light regions too
  bool drop_early = true;        ///< give records back as soon as a rule is broken, not on closing
};

}  // namespace runmark
