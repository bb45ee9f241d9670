#pragma once

#include <algorithm>
#include <cstdlib>

namespace runmark {

/// How many pixels the images of an exhaustive test may have: `wanted`, or less when
/// RUNMARK_EXHAUSTIVE_PIXELS says so (the sanitizers' runs do).
inline int pixel_limit(int wanted) {
  const char* limit = std::getenv("RUNMARK_EXHAUSTIVE_PIXELS");
  return limit == nullptr ? wanted : std::clamp(std::atoi(limit), 1, wanted);
}

/// Whether this is such a shortened run.
inline bool shortened() { return pixel_limit(20) < 20; }

}  // namespace runmark
