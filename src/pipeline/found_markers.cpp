#include "pipeline/found_markers.h"

#include <algorithm>
#include <cmath>

namespace runmark {
namespace {

Point middle_of(const std::array<Point, 4>& c) {
  return {(c[0].x + c[1].x + c[2].x + c[3].x) / 4, (c[0].y + c[1].y + c[2].y + c[3].y) / 4};
}

}  // namespace

bool FoundMarkers::has(const std::array<Point, 4>& corners) const {
  // Two markers that do not overlap have their middles at least half a side apart, however they lie.
  const Point in_region = middle_of(corners);
  const Point middle{in_region.x + origin_.x, in_region.y + origin_.y};
  const double area = area_of(corners);
  return std::any_of(markers_.rbegin(), markers_.rend(), [&](const Marker& marker) {
    const Point other = middle_of(marker.corners);
    const double other_area = area_of(marker.corners);
    const double dx = other.x - middle.x;
    const double dy = other.y - middle.y;
    const double smaller = std::min(area, other_area);
    return dx * dx + dy * dy < 0.09 * smaller && std::max(area, other_area) < 2.5 * smaller;
  });
}

bool FoundMarkers::add(const Marker& marker) {
  if (markers_.size() == markers_.capacity()) return false;
  markers_.push_back(marker);
  for (Point& corner : markers_.back().corners) corner = {corner.x + origin_.x, corner.y + origin_.y};
  return true;
}

}  // namespace runmark
