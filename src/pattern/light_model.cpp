#include "pattern/light_model.h"

#include <array>
#include <cmath>

namespace runmark {
namespace {

/// Least squares plane through grey levels at cell coordinates.
class PlaneFit {
 public:
  void add(double u, double v, double grey) {
    n_ += 1;
    u_ += u;
    v_ += v;
    uu_ += u * u;
    uv_ += u * v;
    vv_ += v * v;
    g_ += grey;
    gu_ += grey * u;
    gv_ += grey * v;
  }

  [[nodiscard]] GreyPlane plane() const {
    const double mu = u_ / n_;
    const double mv = v_ / n_;
    const double mg = g_ / n_;
    const double cuu = uu_ / n_ - mu * mu;
    const double cuv = uv_ / n_ - mu * mv;
    const double cvv = vv_ / n_ - mv * mv;
    const double cgu = gu_ / n_ - mg * mu;
    const double cgv = gv_ / n_ - mg * mv;
    const double det = cuu * cvv - cuv * cuv;
    const double du = (cgu * cvv - cgv * cuv) / det;
    const double dv = (cgv * cuu - cgu * cuv) / det;
    return {mg - du * mu - dv * mv, du, dv};
  }

 private:
  double n_ = 0;
  double u_ = 0;
  double v_ = 0;
  double uu_ = 0;
  double uv_ = 0;
  double vv_ = 0;
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
  PlaneFit inside;
  PlaneFit outside;
  // Cell middles along the four sides, just inside and just outside the square.
  const auto place = [&](int k, double depth) {
    const int side = k / width;
    const double along = k % width + 0.5;
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
  for (int k = 0; k < ring; ++k) {
    const auto in = place(k, 0.5);
    const auto out = place(k, -0.5);
    const double grey = grey_at(in);
    inside_grey[static_cast<std::size_t>(k)] = grey;
    inside.add(in[0], in[1], grey);
    outside.add(out[0], out[1], grey_at(out));
  }
  const LightModel model{inside.plane(), outside.plane()};
  const double sign = light_inside ? -1 : 1;
  const double middle = width / 2.0;
  if (sign * (model.outside.at(middle, middle) - model.inside.at(middle, middle)) < least_contrast) {
    return std::nullopt;
  }
  int wrong = 0;
  for (int k = 0; k < ring; ++k) {
    const auto in = place(k, 0.5);
    const double half = (model.inside.at(in[0], in[1]) + model.outside.at(in[0], in[1])) / 2;
    wrong += sign * (half - inside_grey[static_cast<std::size_t>(k)]) <= 0 ? 1 : 0;
  }
  if (wrong > ring / one_in) return std::nullopt;
  return model;
}

}  // namespace runmark
