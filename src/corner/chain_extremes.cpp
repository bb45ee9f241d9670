#include "corner/chain_extremes.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace runmark {
namespace {

using Sixteen = std::array<NumberedVertex, 16>;

/// How far a vertex lies in the directions 0 to 7; 8 to 15 are their opposites. Shifts and sums only.
constexpr std::array<std::int32_t, 8> reach(std::int32_t x, std::int32_t y) {
  return {x, 2 * x + y, x + y, x + 2 * y, y, 2 * y - x, y - x, y - 2 * x};
}

std::size_t farthest_from(const Sixteen& points, const NumberedVertex& from) {
  std::size_t best = 0;
  std::int64_t most = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int64_t dx = points[i].x - from.x;
    const std::int64_t dy = points[i].y - from.y;
    const std::int64_t distance = dx * dx + dy * dy;
    if (distance > most) {
      most = distance;
      best = i;
    }
  }
  return best;
}

/// The points farthest from the line a -> b on either side; `a` itself where there is none.
std::pair<std::size_t, std::size_t> farthest_from_line(const Sixteen& points, std::size_t a, std::size_t b) {
  const std::int64_t ux = points[b].x - points[a].x;
  const std::int64_t uy = points[b].y - points[a].y;
  std::pair<std::size_t, std::size_t> best{a, a};
  std::int64_t most_right = 0;
  std::int64_t most_left = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int64_t across = ux * (points[i].y - points[a].y) - uy * (points[i].x - points[a].x);
    if (across > most_right) {
      most_right = across;
      best.first = i;
    } else if (across < most_left) {
      most_left = across;
      best.second = i;
    }
  }
  return best;
}

}  // namespace

ChainExtremes chain_extremes(const ClosedChain& chain) {
  ChainExtremes result;
  std::array<std::int32_t, 16> most{};
  std::int32_t number = 0;
  const auto vertex = [&](std::int32_t x, std::int32_t y) {
    const auto forward = reach(x, y);
    for (std::size_t i = 0; i < 16; ++i) {
      const std::int32_t value = i < 8 ? forward[i] : -forward[i - 8];
      if (number == 0 || value > most[i]) {
        most[i] = value;
        result.farthest[i] = {x, y, number};
      }
    }
    ++number;
  };
  std::int64_t area = 0;
  chain.runs([&](std::int32_t from, std::int32_t to, std::int32_t y) {
    vertex(from, y);
    vertex(to, y);
    area += static_cast<std::int64_t>(y) * (from - to);
  });
  result.area = area < 0 ? -area : area;
  return result;
}

std::optional<std::array<NumberedVertex, 4>> widest_corners(const ChainExtremes& extremes) {
  const Sixteen& points = extremes.farthest;
  std::size_t a = farthest_from(points, points[0]);
  std::size_t c = farthest_from(points, points[a]);
  std::size_t b = 0;
  std::size_t d = 0;
  for (int round = 0; round < 2; ++round) {
    std::tie(d, b) = farthest_from_line(points, a, c);
    std::tie(c, a) = farthest_from_line(points, b, d);
  }
  std::array<NumberedVertex, 4> corners{points[a], points[b], points[c], points[d]};
  std::sort(corners.begin(), corners.end(),
            [](const NumberedVertex& p, const NumberedVertex& q) { return p.number < q.number; });
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    if (corners[i].number == corners[i + 1].number) return std::nullopt;
  }
  return corners;
}

}  // namespace runmark
