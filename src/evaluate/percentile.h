#pragma once

#include <algorithm>
#include <vector>

namespace runmark {

/// The value that this share of a sorted list stays below: 0.5 is the median; 0 of an empty list.
[[nodiscard]] inline double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto place = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  return sorted[std::min(place, sorted.size() - 1)];
}

}  // namespace runmark
