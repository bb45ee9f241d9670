#include "pattern/light_model.h"

#include <array>
#include <cmath>

namespace runmark {
namespace {

/// Least squares plane through the grey levels of a ring of cell middles, which lies evenly round the middle
/// of the square: the slopes do not mix.
class PlaneFit {
 public:
  explicit PlaneFit(double middle) : middle_(middle) {}

  void add(double u, double v, double grey) {
    const double du = u - middle_;
    const double dv = v - middle_;
    n_ += 1;
    uu_ += du * du;
    g_ += grey;
    gu_ += grey * du;
    gv_ += grey * dv;
  }

  [[nodiscard]] GreyPlane plane() const {
    const double du = gu_ / uu_;
    const double dv = gv_ / uu_;
    return {g_ / n_ - (du + dv) * middle_, du, dv};
  }

 private:
  double middle_;
  double n_ = 0;
  double uu_ = 0;  // the same along u and along v
  double g_ = 0;
  double gu_ = 0;
  double gv_ = 0;
};

}  // namespace

std::optional<LightModel> fit_light(const GreyFrame& frame, const Homography& cells, int width,
                                    bool light_inside, int one_in) {
  constexpr int most_side = 16;
  constexpr double least_contrast = 8;
  std::array<double, 4 * most_side> inside_grey{};
  const int ring = 4 * width;
  const double middle = width / 2.0;
  PlaneFit inside(middle);
  PlaneFit outside(middle);
  // Cell middles along the four sides, just inside and just outside the square.
  const auto place = [&](int side, double along, double depth) {
    switch (side) {
      case 0:
        return std::array{along, depth};
      case 1:
        return std::array{width - depth, along};
      case 2:
        return std::array{width - along, width - depth};
      default:
        return std::array{depth, width - along};
    }
  };
  const auto grey_at = [&](std::array<double, 2> uv) {
    const Point p = cells(uv[0], uv[1]);
    return static_cast<double>(frame.sample(static_cast<float>(p.x), static_cast<float>(p.y)));
  };
  std::size_t seen = 0;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < width; ++i) {
      const auto in = place(side, i + 0.5, 0.5);
      const auto out = place(side, i + 0.5, -0.5);
      const double grey = grey_at(in);
      inside_grey[seen++] = grey;
      inside.add(in[0], in[1], grey);
      outside.add(out[0], out[1], grey_at(out));
    }
  }
  const LightModel model{inside.plane(), outside.plane()};
  const double sign = light_inside ? -1 : 1;
  if (sign * (model.outside.at(middle, middle) - model.inside.at(middle, middle)) < least_contrast) {
    return std::nullopt;
  }
  int wrong = 0;
  seen = 0;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < width; ++i) {
      const auto [u, v] = place(side, i + 0.5, 0.5);
      const double half = (model.inside.at(u, v) + model.outside.at(u, v)) / 2;
      wrong += sign * (half - inside_grey[seen++]) <= 0 ? 1 : 0;
    }
  }
  if (wrong > ring / one_in) return std::nullopt;
  return model;
}

}  // namespace runmark
