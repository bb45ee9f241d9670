#pragma once

#include <string>
#include <vector>

#include "bench/side_by_side/run.h"

namespace runmark::bench {

/// One self-contained HTML page: scores, plots, times, and pictures of the worst misses and of every false
/// alarm of each detector.
/// @param title  what the images are
[[nodiscard]] std::string comparison_page(const std::string& title, const std::vector<TruthImage>& truth,
                                          const TruthFolder& folder, const std::vector<Run>& runs);

}  // namespace runmark::bench
