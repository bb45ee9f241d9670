#pragma once

#include <vector>

#include "evaluate/matching.h"

namespace runmark {

/// Corner errors of a group of markers, in pixels.
class CornerErrors {
 public:
  /// @param outward  part of the error that points away from the marker's centre
  void add(Point error, double outward);

  void add(const CornerErrors& more);

  [[nodiscard]] std::size_t count() const { return lengths_.size(); }
  [[nodiscard]] double rms() const;
  /// The length that this share of the corners stays below; 0 without any.
  [[nodiscard]] double percentile(double share) const;
  /// Mean error; x goes right, y down.
  [[nodiscard]] Point bias() const;
  /// Mean of the outward parts: positive when corners are reported too far out.
  [[nodiscard]] double outward_bias() const;

 private:
  std::vector<double> lengths_;
  Point sum_{};
  double outward_ = 0;
};

/// The score of a group of markers.
struct Tally {
  int truth = 0;
  int found = 0;
  int bad_corners = 0;  ///< right id and place, but a corner is off
  int rotated = 0;      ///< found, but not in the right corner order
  int false_alarms = 0;
  int extra = 0;
  int duplicates = 0;
  CornerErrors corners{};  ///< of the found ones whose truth is exact

  void add(const TruthMarker& marker, const MarkerMatch& match);
  void add(ReportKind report);
  [[nodiscard]] double recall() const { return truth == 0 ? 0 : static_cast<double>(found) / truth; }
};

}  // namespace runmark
