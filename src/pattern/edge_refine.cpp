#include "pattern/edge_refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "corner/line_fit.h"
#include "pattern/bow_fit.h"
#include "pattern/edge_rises.h"

namespace runmark {
namespace {

constexpr int most_lines = EdgeRises::most_lines;
constexpr double least_window = 1.25;

/// The edge's tangents at the side's two ends: corners are where those of neighbouring sides meet.
struct SideEdge {
  Line at_start;
  Line at_end;
  double blur;  // standard deviation, pixels
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
    sign_ = rises != light_inside ? 1 : -1;
  }

  /// @param widest  half the width of a blurred edge may be so much
  /// @param least_weight  sum of the squared rises of a line that an edge crosses, at least
  [[nodiscard]] std::optional<SideEdge> find(double reach, double widest, float least_weight) {
    constexpr double long_side = 48;  // pixels; shorter ones bow too little to tell
    const double across = reach / cosine_;
    take_rises(across);
    if (rises_.lines < 2) return std::nullopt;
    Bow bow;
    if (!coarse(across, least_weight, bow)) return std::nullopt;
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
    return SideEdge{tangent(bow, 0), tangent(bow, 1), spread_ * cosine_};
  }

 private:
  void take_rises(double across) {
    constexpr double margin = 0.06;  // of the side at each end, where blur rounds the corner
    // Long sides: so many neighbouring lines count as one, against noise.
    constexpr int pixels_a_line = 40;
    constexpr int most_beside = 4;
    const double low = std::min(start_.x, end_.x);
    const double size = std::fabs(end_.x - start_.x);
    const int along_limit = steep_ ? frame_.height : frame_.width;
    const int first = std::max(static_cast<int>(std::ceil(low + margin * size)), 0);
    const int last = std::min(static_cast<int>(std::floor(low + (1 - margin) * size)), along_limit - 1);
    const int count = last - first + 1;
    rises_.lines = std::clamp(count, 0, most_lines);
    const int half = std::min(static_cast<int>(std::ceil(across)) + 1, (EdgeRises::most_rises - 1) / 2);
    rises_.rises = 2 * half + 1;
    const int across_limit = (steep_ ? frame_.width : frame_.height) - 1;
    const double slope = (end_.y - start_.y) / (end_.x - start_.x);
    const int beside = std::clamp(count / pixels_a_line, 1, most_beside);
    const float share = static_cast<float>(sign_) / static_cast<float>(beside);
    // Where each line lies, before any is looked at: none has to wait for another.
    int place[most_lines];
    int from[most_lines];
    for (int i = 0; i < rises_.lines; ++i) {
      // Evenly spread over the lines there are.
      place[i] = first + (rises_.lines == 1 ? 0 : i * (count - beside) / (rises_.lines - 1));
      const double centre = place[i] + (beside - 1) / 2.0;
      share_[i] = (centre - start_.x) / (end_.x - start_.x);
      const double middle = start_.y + slope * (centre - start_.x);
      from[i] = static_cast<int>(std::floor(middle)) - half;
      rises_.first[i] = static_cast<float>(from[i] + 0.5 - middle);
    }
    // Of all lines side by side; of lines that are not used it does not rise.
    int level[EdgeRises::most_rises + 1][most_lines];  // NOLINT(*-member-init): cleared as far as used
    for (int k = 0; k <= rises_.rises; ++k) std::fill_n(level[k], most_lines, 0);
    for (int i = 0; i < rises_.lines; ++i) {
      const bool inside = from[i] >= 0 && from[i] + rises_.rises <= across_limit;
      const auto add = [&](auto&& grey_at) {
        for (int k = 0; k <= rises_.rises; ++k) level[k][i] += grey_at(k);
      };
      for (int line = place[i]; line < place[i] + beside; ++line) {
        if (!inside) {
          add([&](int k) { return grey(line, std::clamp(from[i] + k, 0, across_limit)); });
        } else if (steep_ && frame_.format == PixelFormat::grey && frame_.step == 1) {
          const std::uint8_t* row = frame_.rows[line] + from[i];
          add([&](int k) { return int{row[k]}; });
        } else if (!steep_ && frame_.format == PixelFormat::grey) {
          const std::uint8_t* const* row = frame_.rows + from[i];
          const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(line) * frame_.step;
          add([&](int k) { return int{row[k][column]}; });
        } else {
          add([&](int k) { return grey(line, from[i] + k); });
        }
      }
    }
    for (int k = 0; k < rises_.rises; ++k) {
      for (int i = 0; i < most_lines; ++i) {
        rises_.rise[k][i] = static_cast<float>(level[k + 1][i] - level[k][i]) * share;
      }
    }
    for (int i = std::max(rises_.lines, 0); i < most_lines; ++i) rises_.first[i] = 0;
  }

  [[nodiscard]] int grey(int along, int across) const {
    return steep_ ? frame_.at(across, along) : frame_.at(along, across);
  }

  /// Squared rises single out the strongest edge within reach.
  [[nodiscard]] bool coarse(double across, float least_weight, Bow& bow) const {
    EdgeMoments moments{};
    square_moments(rises_, static_cast<float>(across + 0.5), moments);
    BowFit fit;
    int clear = 0;
    for (int i = 0; i < rises_.lines; ++i) {
      if (moments.weight[i] < least_weight) continue;
      fit.add(share_[i], static_cast<double>(moments.weight[i]), static_cast<double>(moments.sum[i]));
      ++clear;
    }
    if (clear < 2 || clear < rises_.lines / 2) return false;
    bow = fit.straight();
    return std::max(std::fabs(bow.at(0)), std::fabs(bow.at(1))) <= across + 1;
  }

  /// Where the edge found so far crosses each line.
  void cross_lines(const Bow& bow, float* offset) const {
    for (int i = 0; i < rises_.lines; ++i) offset[i] = static_cast<float>(bow.at(share_[i]));
    for (int i = rises_.lines; i < most_lines; ++i) offset[i] = 0;
  }

  /// Half the width of the window that holds the edge: more where blur has widened it.
  [[nodiscard]] double window(double across, const Bow& bow) {
    float offset[most_lines];
    cross_lines(bow, offset);
    const auto near = static_cast<double>(window_sum(rises_, offset, 0.75F));
    const auto all = static_cast<double>(window_sum(rises_, offset, static_cast<float>(across)));
    if (near <= 0) return across;
    // A Gaussian edge has half of its rise within 0.67 standard deviations on both sides.
    spread_ = 0.6 * all / near;
    return std::clamp(1.7 * spread_, least_window, std::max(across, least_window));
  }

  /// The first moment of the rises in a window about the edge found so far. What the window cuts off makes
  /// the moment move less than the edge does; `gain` is by how much.
  [[nodiscard]] bool fine(double width, bool may_bow, Bow& bow) const {
    constexpr float least_rise = 4;
    constexpr double least_gain = 0.3;
    float offset[most_lines];
    cross_lines(bow, offset);
    EdgeMoments moments{};
    const auto cut = static_cast<double>(window_moments(rises_, offset, static_cast<float>(width), moments));
    double all = 0;
    for (int i = 0; i < rises_.lines; ++i) all += static_cast<double>(moments.weight[i]);
    const double gain = std::max(1 - cut / std::max(all, 1.0), least_gain);
    BowFit fit;
    int clear = 0;
    for (int i = 0; i < rises_.lines; ++i) {
      if (moments.weight[i] < least_rise) continue;
      const auto weight = static_cast<double>(moments.weight[i]);
      fit.add(share_[i], weight, weight * bow.at(share_[i]) + static_cast<double>(moments.sum[i]) / gain);
      ++clear;
    }
    if (clear < 2 || clear < rises_.lines / 2) return false;
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
  int sign_ = 1;
  const GreyFrame& frame_;
  EdgeRises rises_;
  double spread_ = std::numeric_limits<double>::infinity();  // standard deviation of the rises, across
  double share_[most_lines]{};                               // of the way from start to end, of each line
};

/// How much lighter it is outside than inside, that far from the middle of the clearest side.
double contrast_across(const GreyFrame& frame, const Quad& quad, double distance) {
  const auto grey = [&](double x, double y) {
    return frame.at(static_cast<int>(std::clamp(x + 0.5, 0.0, frame.width - 1.0)),
                    static_cast<int>(std::clamp(y + 0.5, 0.0, frame.height - 1.0)));
  };
  int most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = quad.corners[i];
    const Point b = quad.corners[(i + 1) % 4];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const Point out{(b.y - a.y) / length * distance, (a.x - b.x) / length * distance};
    const int rise = grey(middle.x + out.x, middle.y + out.y) - grey(middle.x - out.x, middle.y - out.y);
    most = std::max(most, quad.light_inside ? -rise : rise);
  }
  return most;
}

}  // namespace

Quad refine_edges(const GreyFrame& frame, const Quad& quad, int cells, double reach) {
  const double area = std::max(area_of(quad.corners), 1.0);
  const double side = std::sqrt(area);
  const double within_cell = std::max(0.8, 0.8 * side / cells);
  const double search = std::min(reach, within_cell);
  // In the dark soft edges have small rises; elsewhere as small ones are noise where there is no edge.
  const double contrast = contrast_across(frame, quad, search);
  const auto least_weight = static_cast<float>(std::clamp(contrast * contrast / 25, 8.0, 64.0));
  std::array<SideEdge, 4> sides{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = quad.corners[i];
    const Point b = quad.corners[(i + 1) % 4];
    const double depth = area / std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)) /
                         cells;  // of a cell, across the side
    const auto edge =
        SideEdgeSearch(frame, a, b, quad.light_inside).find(search, std::min(0.5 * depth, 8.0), least_weight);
    if (!edge) return quad;
    sides[i] = *edge;
  }
  Quad refined = quad;
  refined.blur = std::max({sides[0].blur, sides[1].blur, sides[2].blur, sides[3].blur});
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
