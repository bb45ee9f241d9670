#include "pipeline/found_markers.h"

#include <algorithm>
#include <cmath>

namespace runmark {
namespace {

Point middle_of(const std::array<Point, 4>& c) {
  return {(c[0].x + c[1].x + c[2].x + c[3].x) / 4, (c[0].y + c[1].y + c[2].y + c[3].y) / 4};
}

std::array<Point, 4> moved(std::array<Point, 4> corners, Point by) {
  for (Point& corner : corners) corner = {corner.x + by.x, corner.y + by.y};
  return corners;
}

/// At the same place and of a like size. Two markers that do not overlap have their middles at least half a
/// side apart, however they lie.
class SamePlace {
 public:
  explicit SamePlace(const std::array<Point, 4>& corners)
      : middle_(middle_of(corners)), area_(area_of(corners)) {}

  bool operator()(const std::array<Point, 4>& corners) const {
    const Point other = middle_of(corners);
    const double other_area = area_of(corners);
    const double dx = other.x - middle_.x;
    const double dy = other.y - middle_.y;
    const double smaller = std::min(area_, other_area);
    return dx * dx + dy * dy < 0.09 * smaller && std::max(area_, other_area) < 2.5 * smaller;
  }
  bool operator()(const Marker& marker) const { return (*this)(marker.corners); }

 private:
  Point middle_;
  double area_;
};

}  // namespace

bool FoundMarkers::has(const std::array<Point, 4>& corners) const {
  return std::any_of(markers_.rbegin(), markers_.rend(), SamePlace(moved(corners, origin_)));
}

bool FoundMarkers::add(const Marker& marker) {
  if (markers_.size() == markers_.capacity()) return false;
  markers_.push_back(marker);
  markers_.back().corners = moved(marker.corners, origin_);
  return true;
}

void FoundMarkers::keep_rejected(const std::array<Point, 4>& corners) {
  const auto in_frame = moved(corners, origin_);
  if (std::ranges::none_of(rejected_, SamePlace(in_frame))) rejected_.push_back(in_frame);
}

void FoundMarkers::end_frame() {
  std::erase_if(rejected_,
                [this](const auto& corners) { return std::ranges::any_of(markers_, SamePlace(corners)); });
}

}  // namespace runmark
