#pragma once

#include <cstddef>
#include <span>

#include "preprocess/crack_runs.h"

namespace runmark::fast {

/// Room to leave behind the runs of a row: so many more may be written over, never read.
inline constexpr std::size_t crack_runs_slack = 8;

/// The same as find_crack_runs, without a branch for each run.
/// @param runs  room for max_crack_runs(width) + crack_runs_slack
std::size_t find_crack_runs(const BitWord* above, const BitWord* current, int width,
                            Connectivity connectivity, std::span<CrackRun> runs);

}  // namespace runmark::fast
