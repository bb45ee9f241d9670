#pragma once

#include <vector>

#include "bench/side_by_side/run.h"
#include "evaluate/tally.h"

namespace runmark::bench {

/// Corner errors on the markers that all detectors found: the only fair comparison, since who finds more
/// finds harder ones.
struct SharedMarkers {
  int count = 0;
  std::vector<CornerErrors> total;                 ///< by detector
  std::vector<std::vector<CornerErrors>> by_size;  ///< by detector, then by size bucket
};

[[nodiscard]] SharedMarkers shared_markers(const std::vector<TruthImage>& truth,
                                           const std::vector<Run>& runs);

}  // namespace runmark::bench
