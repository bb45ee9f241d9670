#pragma once

#include <ctime>

namespace runmark::bench {

/// CPU time of this thread in milliseconds: what other programs take of the machine does not count.
[[nodiscard]] inline double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

}  // namespace runmark::bench
