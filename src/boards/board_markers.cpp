#include "boards/board_markers.h"

#include <algorithm>
#include <cmath>

#include "boards/plane_map.h"
#include "camera/point_distance.h"
#include "corner/quad.h"

namespace runmark {
namespace {

double place_size(const BoardMarker& m) {
  return std::hypot(m.corners[1].x - m.corners[0].x, m.corners[1].y - m.corners[0].y);
}

void count_support(const Board& board, std::vector<Candidate>& all) {
  constexpr std::size_t most_neighbours = 6;
  for (Candidate& c : all) {
    const BoardMarker& place = board.markers[static_cast<std::size_t>(c.index)];
    const auto map = PlaneMap::fit({{place.corners[0].x, place.corners[0].y},
                                    {place.corners[1].x, place.corners[1].y},
                                    {place.corners[2].x, place.corners[2].y},
                                    {place.corners[3].x, place.corners[3].y}},
                                   {c.marker->corners.begin(), c.marker->corners.end()});
    if (!map) continue;
    std::vector<const Candidate*> others;
    for (const Candidate& o : all) {
      if (o.index != c.index) others.push_back(&o);
    }
    const auto nearer = [&](const Candidate* a, const Candidate* b) {
      const Point here = middle_of(place);
      return distance(here, middle_of(board.markers[static_cast<std::size_t>(a->index)])) <
             distance(here, middle_of(board.markers[static_cast<std::size_t>(b->index)]));
    };
    std::stable_sort(others.begin(), others.end(), nearer);
    others.resize(std::min(others.size(), most_neighbours));
    c.neighbours = static_cast<int>(others.size());
    for (const Candidate* o : others) {
      const double size = std::sqrt(std::max(area_of(o->marker->corners), 0.0));
      const Point goal = middle_of(board.markers[static_cast<std::size_t>(o->index)]);
      // The farther off, the less four corners can tell.
      const double away = distance(goal, middle_of(place)) / place_size(place);
      if (distance((*map)(goal), middle_of(*o->marker)) < (0.4 + 0.1 * away) * size) ++c.support;
    }
  }
}

}  // namespace

Point middle_of(const BoardMarker& marker) {
  const auto& c = marker.corners;
  return {(c[0].x + c[1].x + c[2].x + c[3].x) / 4, (c[0].y + c[1].y + c[2].y + c[3].y) / 4};
}

Point middle_of(const Marker& marker) {
  const auto& c = marker.corners;
  return {(c[0].x + c[1].x + c[2].x + c[3].x) / 4, (c[0].y + c[1].y + c[2].y + c[3].y) / 4};
}

bool is_flat(const Board& board) {
  return std::all_of(board.markers.begin(), board.markers.end(), [](const BoardMarker& m) {
    return std::all_of(m.corners.begin(), m.corners.end(), [](const Point3& p) { return p.z == 0; });
  });
}

std::vector<Candidate> candidates(const Board& board, std::span<const Marker> found) {
  std::vector<Candidate> all;
  for (const Marker& marker : found) {
    const auto same = std::find_if(board.markers.begin(), board.markers.end(), [&](const BoardMarker& m) {
      return m.id == marker.id && (m.dictionary.empty() || m.dictionary == marker.dictionary);
    });
    if (same == board.markers.end() || !is_convex_clockwise(marker.corners)) continue;
    all.push_back({static_cast<int>(same - board.markers.begin()), &marker, 0, 0});
  }
  if (is_flat(board)) count_support(board, all);
  return all;
}

std::vector<Candidate> agreeing(std::vector<Candidate> all) {
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return a.index != b.index ? a.index < b.index : a.support > b.support;
  });
  const auto same = [](const Candidate& a, const Candidate& b) { return a.index == b.index; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  const bool some_supported =
      std::any_of(all.begin(), all.end(), [](const Candidate& c) { return c.support > 0; });
  std::erase_if(all,
                [&](const Candidate& c) { return some_supported && c.neighbours > 0 && c.support == 0; });
  return all;
}

}  // namespace runmark
