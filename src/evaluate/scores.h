#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evaluate/tally.h"

namespace runmark {

/// One way to split the markers: by size, by dictionary and so on.
struct Breakdown {
  std::string name{};
  std::vector<std::pair<std::string, Tally>> rows;  ///< in the order of the buckets; none is empty
};

/// A marker that was not reported as it is, or a report of one that is not there.
struct Mistake {
  enum class Kind : std::uint8_t { missed, bad_corner, rotated, false_alarm };
  Kind kind = Kind::missed;
  std::string image{};
  int id = -1;
  Corners corners{};  ///< of the truth, or of the false report
};

/// How a detector did on a set of images.
struct Scores {
  std::size_t images = 0;
  Tally total;
  std::vector<Breakdown> breakdowns{};
  std::vector<Mistake> mistakes{};
  std::vector<double> milliseconds{};  ///< of each image whose time is known, sorted
};

[[nodiscard]] std::string_view name_of(Mistake::Kind kind);

/// Scores observations against the truth. An image without observations counts as seen without markers.
[[nodiscard]] Scores score(const std::vector<TruthImage>& truth, const Observations& observations);

}  // namespace runmark
