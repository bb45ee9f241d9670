#include "evaluate/matching.h"

#include <algorithm>

namespace runmark {
namespace {

constexpr double centre_tolerance = 0.35;  // sides
constexpr double corner_tolerance = 0.1;   // sides
constexpr double corner_tolerance_px = 3;

bool same_place(const Observation& report, const TruthMarker& marker, double side) {
  return report.id == marker.id &&
         distance(centre(report.corners), centre(marker.corners)) <= centre_tolerance * side;
}

struct Fit {
  double worst = 0;
  int rotation = -1;
};

Fit best_rotation(const Corners& report, const Corners& truth) {
  Fit best;
  for (int rotation = 0; rotation < 4; ++rotation) {
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      worst = std::max(worst, distance(report[(i + static_cast<std::size_t>(rotation)) % 4], truth[i]));
    }
    if (best.rotation < 0 || worst < best.worst) best = {worst, rotation};
  }
  return best;
}

bool near_any(const Observation& report, std::span<const TruthMarker> markers) {
  return std::ranges::any_of(markers, [&](const TruthMarker& marker) {
    return report.id == marker.id && distance(centre(report.corners), centre(marker.corners)) <
                                         centre_tolerance * mean_side(marker.corners);
  });
}

MarkerMatch match_marker(const TruthMarker& marker, std::span<const Observation> observations,
                         std::span<const ReportKind> reports) {
  const double side = mean_side(marker.corners);
  MarkerMatch match;
  double least = 0;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (reports[i] == ReportKind::matched || !same_place(observations[i], marker, side)) continue;
    const Fit fit = best_rotation(observations[i].corners, marker.corners);
    if (match.observation >= 0 && fit.worst >= least) continue;
    least = fit.worst;
    match.observation = static_cast<int>(i);
    match.rotation = fit.rotation;
  }
  if (match.observation < 0) return match;
  const bool good = least <= std::max(corner_tolerance_px, corner_tolerance * side);
  match.outcome = good ? MarkerMatch::Outcome::found : MarkerMatch::Outcome::bad_corner;
  const Corners& corners = observations[static_cast<std::size_t>(match.observation)].corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point report = corners[(i + static_cast<std::size_t>(match.rotation)) % 4];
    match.error[i] = {report.x - marker.corners[i].x, report.y - marker.corners[i].y};
  }
  return match;
}

ReportKind kind_of(const Observation& report, const TruthImage& truth) {
  if (near_any(report, truth.markers) || near_any(report, truth.maybe)) return ReportKind::duplicate;
  const bool present = std::ranges::find(truth.present_ids, report.id) != truth.present_ids.end();
  return present ? ReportKind::extra : ReportKind::false_alarm;
}

}  // namespace

ImageMatch match(const TruthImage& truth, std::span<const Observation> observations) {
  ImageMatch result;
  std::vector<ReportKind>& reports = result.reports;
  reports.assign(observations.size(), ReportKind::false_alarm);
  for (const TruthMarker& marker : truth.markers) {
    result.markers.push_back(match_marker(marker, observations, reports));
    const int taken = result.markers.back().observation;
    if (taken >= 0) reports[static_cast<std::size_t>(taken)] = ReportKind::matched;
  }
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (reports[i] != ReportKind::matched) reports[i] = kind_of(observations[i], truth);
  }
  return result;
}

}  // namespace runmark
