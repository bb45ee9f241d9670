#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "evaluate/observations.h"
#include "evaluate/truth.h"

namespace runmark {

/// What became of a marker of the truth.
struct MarkerMatch {
  enum class Outcome : std::uint8_t { missed, found, bad_corner };
  Outcome outcome = Outcome::missed;
  int observation = -1;          ///< index of the report that belongs to it
  int rotation = 0;              ///< quarter turns from the report's corner order to the truth's; 0 is right
  std::array<Point, 4> error{};  ///< reported minus true corner, in the truth's order
  [[nodiscard]] bool found() const { return outcome == Outcome::found; }
};

/// What a report was.
enum class ReportKind : std::uint8_t {
  matched,      ///< belongs to a marker of the truth
  duplicate,    ///< a second report of one marker, or of a doubtful one
  extra,        ///< an id that is on the target, where the truth has none: not verified
  false_alarm,  ///< an id that is not there
};

struct ImageMatch {
  std::vector<MarkerMatch> markers;  ///< one for each marker of the truth
  std::vector<ReportKind> reports;   ///< one for each observation
};

/// Gives each marker of the truth at most one report. A report belongs to a marker when it has its id
/// and its centre lies within 0.35 sides of the marker's; of several the one with the smallest largest
/// corner distance in its best rotation. The marker is found when that distance is at most the larger of
/// 3 px and 0.1 sides.
[[nodiscard]] ImageMatch match(const TruthImage& truth, std::span<const Observation> observations);

}  // namespace runmark
