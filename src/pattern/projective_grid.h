#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "corner/integer_quad.h"

namespace runmark {

/// Places the cells of a square marker in the image from all four corners, in integers: the projective map of
/// homography.h, with one division for each coordinate of a cell and none before.
///
/// With k_i twice the area of the triangle of corner i and its two neighbours, corner i of the square has the
/// projective weight k_(i + 2). So the areas, which are positive just when the corners are convex and
/// clockwise, are all there is to compute.
class ProjectiveGrid {
 public:
  /// Nothing when the corners are not convex and clockwise, or nearly not.
  [[nodiscard]] static std::optional<ProjectiveGrid> make(const std::array<SubpixelPoint, 4>& corners,
                                                          int width) {
    std::array<std::int64_t, 4> area{};
    std::int64_t all = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const SubpixelPoint p = corners[(i + 3) % 4];
      const SubpixelPoint q = corners[i];
      const SubpixelPoint r = corners[(i + 1) % 4];
      area[i] = static_cast<std::int64_t>(q.x - p.x) * (r.y - q.y) -
                static_cast<std::int64_t>(q.y - p.y) * (r.x - q.x);
      if (area[i] <= 0) return std::nullopt;
      all |= area[i];
    }
    // Only the areas' proportions matter: 14 bits of the largest.
    while (all >> weight_bits != 0) {
      all >>= 1;
      for (std::int64_t& a : area) a >>= 1;
    }
    return ProjectiveGrid(corners, area, width);
  }

  /// The middle of cell (column, row); also of cells round the square. Nothing where the plane's horizon is
  /// too near.
  [[nodiscard]] std::optional<SubpixelPoint> middle(int column, int row) const {
    const std::int64_t u = 2 * column + 1;
    const std::int64_t v = 2 * row + 1;
    const std::int64_t weight = first_ + u * along_ + v * down_;
    if (weight <= 0) return std::nullopt;
    return SubpixelPoint{origin_.x + near(u * x_along_ + v * x_down_, weight),
                         origin_.y + near(u * y_along_ + v * y_down_, weight)};
  }

 private:
  static constexpr int weight_bits = 14;

  /// The quotient rounded down, kept to where it is certainly outside of any frame.
  static std::int32_t near(std::int64_t offset, std::int64_t weight) {
    constexpr std::int64_t far = std::int64_t{1} << 21;
    const std::int64_t quotient = offset < 0 ? ~(~offset / weight) : offset / weight;
    return static_cast<std::int32_t>(std::clamp(quotient, -far, far));
  }

  ProjectiveGrid(const std::array<SubpixelPoint, 4>& c, const std::array<std::int64_t, 4>& area, int width)
      : origin_(c[0]),
        first_(area[2] * 2 * width),
        along_(area[3] - area[2]),
        down_(area[1] - area[2]),
        x_along_((c[1].x - c[0].x) * area[3]),
        x_down_((c[3].x - c[0].x) * area[1]),
        y_along_((c[1].y - c[0].y) * area[3]),
        y_down_((c[3].y - c[0].y) * area[1]) {}

  SubpixelPoint origin_;
  std::int64_t first_;  // the weight of corner 0, times the half cells of a side
  std::int64_t along_;  // what each half cell adds to it
  std::int64_t down_;
  std::int64_t x_along_;
  std::int64_t x_down_;
  std::int64_t y_along_;
  std::int64_t y_down_;
};

}  // namespace runmark
