#pragma once

#include <string>
#include <vector>

#include "bench/speed/frames.h"

namespace runmark::bench {

/// CPU time of one of the default pipeline's cores on one frame.
struct CoreTime {
  std::string core;
  double milliseconds = 0;
};

/// What each of the five cores takes of a frame: the pipeline is run again and again, each time one core
/// further, and a core's time is what its own run adds (medians of `rounds`). Halving counts to threshold.
[[nodiscard]] std::vector<CoreTime> core_times(const TimedFrame& frame, int rounds);

}  // namespace runmark::bench
