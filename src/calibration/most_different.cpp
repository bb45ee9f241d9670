#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "runmark/calibration.h"

namespace runmark {
namespace {

using Key = std::tuple<double, double, double>;

std::map<Key, Point> by_place(const CalibrationView& view) {
  std::map<Key, Point> places;
  for (std::size_t i = 0; i < view.object.size(); ++i) {
    const Point3& p = view.object[i];
    places[{p.x, p.y, p.z}] = view.image[i];
  }
  return places;
}

/// Mean distance of the corners both show, in pixels; what only one of them shows counts as far away.
double difference(const std::map<Key, Point>& a, const std::map<Key, Point>& b) {
  constexpr double unshared = 100;
  double sum = 0;
  std::size_t shared = 0;
  for (const auto& [key, place] : a) {
    const auto other = b.find(key);
    if (other == b.end()) continue;
    sum += std::hypot(place.x - other->second.x, place.y - other->second.y);
    ++shared;
  }
  const std::size_t all = a.size() + b.size() - shared;
  return (sum + unshared * static_cast<double>(all - shared)) /
         static_cast<double>(std::max<std::size_t>(all, 1));
}

}  // namespace

std::vector<std::size_t> most_different(std::span<const CalibrationView> views, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (views.empty() || most == 0) return chosen;
  std::vector<std::map<Key, Point>> places;
  for (const CalibrationView& view : views) places.push_back(by_place(view));
  // From the one with the most corners on, each time the one farthest from all chosen so far.
  const auto richest = std::max_element(views.begin(), views.end(), [](const auto& a, const auto& b) {
    return a.object.size() < b.object.size();
  });
  chosen.push_back(static_cast<std::size_t>(richest - views.begin()));
  std::vector<double> nearest(views.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(most, views.size())) {
    for (std::size_t i = 0; i < views.size(); ++i) {
      nearest[i] = std::min(nearest[i], difference(places[i], places[chosen.back()]));
    }
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    if (*farthest <= 0) break;
    chosen.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace runmark
