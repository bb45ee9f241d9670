#include "pose/edge_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace runmark {
namespace {

constexpr double used = 0.84;    // of the side: its ends are rounded by blur
constexpr double spacing = 0.5;  // pixels across the side
constexpr int most_lines = 30;
constexpr int most_half = 17;

/// Lines across a side, each a row of grey levels from the inside to the outside.
class Lines {
 public:
  Lines(const GreySampler& grey, Point a, Point b, double reach) {
    const double length = std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-9);
    const Point out{(b.y - a.y) / length, -(b.x - a.x) / length};
    count_ = std::clamp(static_cast<int>(used * length), 6, most_lines);
    half_ = std::min(static_cast<int>(std::ceil(reach / spacing)), most_half);
    for (int i = 0; i < count_; ++i) {
      const double t = (1 - used) / 2 + used * (i + 0.5) / count_;
      const Point on{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      for (int k = -half_; k <= half_; ++k) {
        const double level = grey.between(on.x + k * spacing * out.x, on.y + k * spacing * out.y);
        levels_[at(i, k)] = level;
        mean_[at(0, k)] += level / count_;
      }
    }
    sign_ = mean_[at(0, half_)] > mean_[at(0, -half_)] ? 1 : -1;
  }

  [[nodiscard]] EdgeProfile profile() const {
    double sum = 0;
    double sum_d = 0;
    double sum_d2 = 0;
    for (int k = -half_; k < half_; ++k) {
      const double rise = std::max(0.0, sign_ * (mean_[at(0, k + 1)] - mean_[at(0, k)]));
      const double d = (k + 0.5) * spacing;
      sum += rise;
      sum_d += rise * d;
      sum_d2 += rise * d * d;
    }
    if (sum <= 0) return {half_ * spacing, 1};
    const double centre = sum_d / sum;
    const double width = std::sqrt(std::max(0.0, sum_d2 / sum - centre * centre));
    return {width, scatter(centre, std::clamp(1.7 * width, 1.25, 8.0))};
  }

 private:
  static constexpr std::size_t row = 2 * most_half + 1;
  [[nodiscard]] static std::size_t at(int line, int k) {
    return static_cast<std::size_t>(line) * row + static_cast<std::size_t>(k + most_half);
  }

  /// Of the first moments of the rises in a window about the edge, about a straight line through them.
  [[nodiscard]] double scatter(double centre, double window) const {
    constexpr double least_rise = 4;  // grey levels
    double n = 0;
    double t = 0;
    double tt = 0;
    double p = 0;
    double tp = 0;
    double pp = 0;
    for (int line = 0; line < count_; ++line) {
      double weight = 0;
      double moment = 0;
      for (int k = -half_; k < half_; ++k) {
        const double d = (k + 0.5) * spacing - centre;
        if (std::fabs(d) > window) continue;
        const double rise = sign_ * (levels_[at(line, k + 1)] - levels_[at(line, k)]);
        weight += rise;
        moment += rise * d;
      }
      if (weight < least_rise) continue;
      const double place = moment / weight;
      n += 1;
      t += line;
      tt += line * line;
      p += place;
      tp += line * place;
      pp += place * place;
    }
    if (n < 4) return 1;
    const double along = tt - t * t / n;
    const double across = tp - t * p / n;
    return std::sqrt(std::max(0.0, pp - p * p / n - across * across / along) / (n - 2));
  }

  int count_ = 0;
  int half_ = 0;
  double sign_ = 1;
  std::array<double, most_lines * row> levels_{};
  std::array<double, row> mean_{};
};

}  // namespace

EdgeProfile edge_profile(const GreySampler& grey, Point a, Point b, double reach) {
  return Lines(grey, a, b, reach).profile();
}

}  // namespace runmark
