#pragma once

#include <algorithm>
#include <vector>

#include "bench/cpu_clock.h"
#include "evaluate/percentile.h"

namespace runmark::bench {

/// The median CPU time of `work()` over the rounds, in milliseconds, after one round that does not count.
template <class Work>
[[nodiscard]] double median_time(int rounds, Work&& work) {
  std::vector<double> times;
  for (int round = 0; round <= rounds; ++round) {
    const double start = cpu_milliseconds();
    work();
    if (round > 0) times.push_back(cpu_milliseconds() - start);
  }
  std::ranges::sort(times);
  return percentile(times, 0.5);
}

}  // namespace runmark::bench
