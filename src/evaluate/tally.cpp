#include "evaluate/tally.h"

#include <algorithm>
#include <cmath>

#include "evaluate/percentile.h"

namespace runmark {

void CornerErrors::add(Point error, double outward) {
  lengths_.push_back(std::hypot(error.x, error.y));
  sum_.x += error.x;
  sum_.y += error.y;
  outward_ += outward;
}

void CornerErrors::add(const CornerErrors& more) {
  lengths_.insert(lengths_.end(), more.lengths_.begin(), more.lengths_.end());
  sum_.x += more.sum_.x;
  sum_.y += more.sum_.y;
  outward_ += more.outward_;
}

double CornerErrors::rms() const {
  if (lengths_.empty()) return 0;
  double squares = 0;
  for (const double length : lengths_) squares += length * length;
  return std::sqrt(squares / static_cast<double>(lengths_.size()));
}

double CornerErrors::percentile(double share) const {
  std::vector<double> sorted = lengths_;
  std::ranges::sort(sorted);
  return runmark::percentile(sorted, share);
}

Point CornerErrors::bias() const {
  const double n = std::max(1.0, static_cast<double>(lengths_.size()));
  return {sum_.x / n, sum_.y / n};
}

double CornerErrors::outward_bias() const {
  return outward_ / std::max(1.0, static_cast<double>(lengths_.size()));
}

void Tally::add(const TruthMarker& marker, const MarkerMatch& match) {
  ++truth;
  bad_corners += match.outcome == MarkerMatch::Outcome::bad_corner ? 1 : 0;
  if (!match.found()) return;
  ++found;
  rotated += match.rotation != 0 ? 1 : 0;
  if (!marker.exact_corners) return;
  const Point middle = centre(marker.corners);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point e = match.error[i];
    const Point out = {marker.corners[i].x - middle.x, marker.corners[i].y - middle.y};
    const double reach = std::hypot(out.x, out.y);
    corners.add(e, reach > 0 ? (e.x * out.x + e.y * out.y) / reach : 0);
  }
}

void Tally::add(ReportKind report) {
  duplicates += report == ReportKind::duplicate ? 1 : 0;
  extra += report == ReportKind::extra ? 1 : 0;
  false_alarms += report == ReportKind::false_alarm ? 1 : 0;
}

}  // namespace runmark
