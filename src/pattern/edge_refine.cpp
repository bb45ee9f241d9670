#include "pattern/edge_refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "corner/line_fit.h"
#include "pattern/bow_fit.h"

namespace runmark {
namespace {

constexpr int most_lines = 24;  // of pixels across each side
constexpr int most_rises = 40;  // between pixels of each
constexpr double least_window = 1.25;

/// The edge's tangents at the side's two ends: corners are where those of neighbouring sides meet.
struct SideEdge {
  Line at_start;
  Line at_end;
};

/// One side of the quadrilateral over the pixel rows it crosses, or the columns where it is nearer to level.
/// `along` counts those lines, `across` the pixels on each. Whole pixels need no interpolation, and the mean
/// position of the rises between them is where the edge cut the pixels, at any slope.
class SideEdgeSearch {
 public:
  SideEdgeSearch(const GreyFrame& frame, Point a, Point b, bool light_inside)
      : steep_(std::fabs(b.y - a.y) >= std::fabs(b.x - a.x)),
        start_{steep_ ? a.y : a.x, steep_ ? a.x : a.y},
        end_{steep_ ? b.y : b.x, steep_ ? b.x : b.y},
        length_(std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y))),
        frame_(frame) {
    cosine_ = std::fabs(end_.x - start_.x) / length_;
    // Outwards is to the left hand of a -> b in the image, the corners going clockwise.
    const bool rises = (end_.x > start_.x) == steep_;
    sign_ = rises != light_inside ? 1.0 : -1.0;
  }

  /// @param widest  half the width of a blurred edge may be so much
  [[nodiscard]] std::optional<SideEdge> find(double reach, double widest) {
    constexpr double long_side = 48;  // pixels; shorter ones bow too little to tell
    const double across = reach / cosine_;
    take_rises(across);
    if (lines_ < 2) return std::nullopt;
    Bow bow;
    if (!coarse(across, bow)) return std::nullopt;
    double width = window(across, bow);
    if (width > 0.8 * across && widest > reach) {
      take_rises(widest / cosine_);
      width = window(widest / cosine_, bow);
    }
    width = std::min(width, std::max(widest / cosine_, least_window));
    for (int round = 0; round < 2; ++round) {
      if (!fine(width, length_ > long_side, bow)) return std::nullopt;
    }
    if (std::max(std::fabs(bow.at(0)), std::fabs(bow.at(1))) > across + 1) return std::nullopt;
    return SideEdge{tangent(bow, 0), tangent(bow, 1)};
  }

 private:
  [[nodiscard]] double share(int i) const { return (place_[i] - start_.x) / (end_.x - start_.x); }

  void take_rises(double across) {
    constexpr double margin = 0.06;  // of the side at each end, where blur rounds the corner
    const double low = std::min(start_.x, end_.x);
    const double size = std::fabs(end_.x - start_.x);
    const int along_limit = steep_ ? frame_.height : frame_.width;
    const int first = std::max(static_cast<int>(std::ceil(low + margin * size)), 0);
    const int last = std::min(static_cast<int>(std::floor(low + (1 - margin) * size)), along_limit - 1);
    const int count = last - first + 1;
    lines_ = std::clamp(count, 0, most_lines);
    const int half = std::min(static_cast<int>(std::ceil(across)) + 1, (most_rises - 1) / 2);
    rises_ = 2 * half + 1;
    const int across_limit = (steep_ ? frame_.width : frame_.height) - 1;
    const double slope = (end_.y - start_.y) / (end_.x - start_.x);
    for (int i = 0; i < lines_; ++i) {
      // Evenly spread over the lines there are.
      const int place = first + (lines_ == 1 ? 0 : i * (count - 1) / (lines_ - 1));
      place_[i] = place;
      const double middle = start_.y + slope * (place - start_.x);
      const int from = static_cast<int>(std::floor(middle)) - half;
      first_[i] = from + 0.5 - middle;
      double before = grey(place, std::clamp(from, 0, across_limit));
      for (int k = 0; k < rises_; ++k) {
        const double after = grey(place, std::clamp(from + k + 1, 0, across_limit));
        rise_[i][k] = sign_ * (after - before);
        before = after;
      }
    }
  }

  [[nodiscard]] double grey(int along, int across) const {
    return static_cast<double>(steep_ ? frame_.at(across, along) : frame_.at(along, across));
  }

  /// Squared rises single out the strongest edge within reach.
  [[nodiscard]] bool coarse(double across, Bow& bow) const {
    constexpr double least_weight = 64;
    BowFit fit;
    int clear = 0;
    for (int i = 0; i < lines_; ++i) {
      double weight = 0;
      double sum = 0;
      double n = first_[i];
      for (int k = 0; k < rises_; ++k, n += 1) {
        const double rise = std::max(rise_[i][k], 0.0);
        if (std::fabs(n) > across + 0.5) continue;
        weight += rise * rise;
        sum += rise * rise * n;
      }
      if (weight < least_weight) continue;
      fit.add(share(i), weight, sum);
      ++clear;
    }
    if (clear < 2 || clear < lines_ / 2) return false;
    bow = fit.straight();
    return std::max(std::fabs(bow.at(0)), std::fabs(bow.at(1))) <= across + 1;
  }

  /// Half the width of the window that holds the edge: more where blur has widened it.
  [[nodiscard]] double window(double across, const Bow& bow) const {
    double near = 0;
    double all = 0;
    for (int i = 0; i < lines_; ++i) {
      double n = first_[i] - bow.at(share(i));
      for (int k = 0; k < rises_; ++k, n += 1) {
        near += std::clamp(1.25 - std::fabs(n), 0.0, 1.0) * rise_[i][k];
        all += std::clamp(across + 0.5 - std::fabs(n), 0.0, 1.0) * rise_[i][k];
      }
    }
    if (near <= 0) return across;
    // A Gaussian edge has half of its rise within 0.67 standard deviations on both sides.
    const double spread = 0.6 * all / near;
    return std::clamp(1.7 * spread, least_window, std::max(across, least_window));
  }

  /// The first moment of the rises in a window about the edge found so far. What the window cuts off makes
  /// the moment move less than the edge does; `gain` is by how much.
  [[nodiscard]] bool fine(double width, bool may_bow, Bow& bow) const {
    constexpr double least_rise = 4;
    constexpr double least_gain = 0.3;
    double weights[most_lines];
    double sums[most_lines];
    double all = 0;
    double cut = 0;
    for (int i = 0; i < lines_; ++i) {
      weights[i] = 0;
      sums[i] = 0;
      double n = first_[i] - bow.at(share(i));
      for (int k = 0; k < rises_; ++k, n += 1) {
        const double rise = std::max(rise_[i][k], 0.0);
        const double inside = width + 0.5 - std::fabs(n);
        if (inside <= 0) continue;
        const double part = std::min(inside, 1.0) * rise;
        weights[i] += part;
        sums[i] += part * n;
        if (inside < 1) cut += rise * std::fabs(n);
      }
      all += weights[i];
    }
    const double gain = std::max(1 - cut / std::max(all, 1.0), least_gain);
    BowFit fit;
    int clear = 0;
    for (int i = 0; i < lines_; ++i) {
      if (weights[i] < least_rise) continue;
      fit.add(share(i), weights[i], weights[i] * bow.at(share(i)) + sums[i] / gain);
      ++clear;
    }
    if (clear < 2 || clear < lines_ / 2) return false;
    bow = may_bow ? fit.bow(clear) : fit.straight();
    return true;
  }

  [[nodiscard]] Line tangent(const Bow& bow, double t) const {
    const Point direction{end_.x - start_.x, end_.y - start_.y + bow.slope(t)};
    const Point on{start_.x + t * (end_.x - start_.x), start_.y + t * (end_.y - start_.y) + bow.at(t)};
    const double size = std::sqrt(direction.x * direction.x + direction.y * direction.y);
    const Point normal{-direction.y / size, direction.x / size};
    const double offset = normal.x * on.x + normal.y * on.y;
    return steep_ ? Line{{normal.y, normal.x}, offset} : Line{normal, offset};
  }

  bool steep_;
  Point start_;  // along, across
  Point end_;
  double length_;
  double cosine_ = 1;
  double sign_ = 1;
  const GreyFrame& frame_;
  int lines_ = 0;
  int rises_ = 0;
  int place_[most_lines];
  double first_[most_lines];  // from the straight side to the first rise
  double rise_[most_lines][most_rises];
};

}  // namespace

Quad refine_edges(const GreyFrame& frame, const Quad& quad, int cells, double reach) {
  const double area = std::max(area_of(quad.corners), 1.0);
  const double side = std::sqrt(area);
  const double within_cell = std::max(0.8, 0.8 * side / cells);
  const double search = std::min(reach, within_cell);
  std::array<SideEdge, 4> sides{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = quad.corners[i];
    const Point b = quad.corners[(i + 1) % 4];
    const double depth = area / std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)) /
                         cells;  // of a cell, across the side
    const auto edge = SideEdgeSearch(frame, a, b, quad.light_inside).find(search, std::min(0.5 * depth, 8.0));
    if (!edge) return quad;
    sides[i] = *edge;
  }
  Quad refined = quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> corner = meet(sides[(i + 3) % 4].at_end, sides[i].at_start);
    if (!corner) return quad;
    const double moved = std::fabs(corner->x - quad.corners[i].x) + std::fabs(corner->y - quad.corners[i].y);
    if (moved > 2 * search + 1) return quad;
    refined.corners[i] = *corner;
  }
  return is_convex_clockwise(refined.corners) ? refined : quad;
}

}  // namespace runmark
