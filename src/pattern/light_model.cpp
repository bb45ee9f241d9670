#include "pattern/light_model.h"

#include <array>

namespace runmark {
namespace {

/// Least squares plane through the grey levels of one ring, from its point `first` on. The ring lies evenly
/// round the middle of the square, so the slopes do not mix.
GreyPlane plane_through(const float* grey, const BorderRings& rings, std::size_t first) {
  const auto count = static_cast<std::size_t>(4 * rings.width);
  const double middle = rings.width / 2.0;
  double sum = 0;
  double sum_u = 0;
  double sum_v = 0;
  double spread = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    const double u = static_cast<double>(rings.points.u[i]) - middle;
    const double v = static_cast<double>(rings.points.v[i]) - middle;
    const auto level = static_cast<double>(grey[i]);
    spread += u * u;
    sum += level;
    sum_u += level * u;
    sum_v += level * v;
  }
  const double du = sum_u / spread;
  const double dv = sum_v / spread;
  return {sum / static_cast<double>(count) - (du + dv) * middle, du, dv};
}

}  // namespace

BorderRings::BorderRings(int cells_across) : width(cells_across) {
  for (const double depth : {0.5, -0.5}) {
    for (int i = 0; i < width; ++i) points.add(i + 0.5, depth);
    for (int i = 0; i < width; ++i) points.add(width - depth, i + 0.5);
    for (int i = 0; i < width; ++i) points.add(width - i - 0.5, width - depth);
    for (int i = 0; i < width; ++i) points.add(depth, width - i - 0.5);
  }
}

std::optional<LightModel> fit_light(const GreyFrame& frame, const Homography& place, const BorderRings& rings,
                                    bool light_inside, int one_in) {
  constexpr double least_contrast = 8;
  std::array<float, std::size_t{8} * BorderRings::most_width> grey;  // NOLINT(*-member-init): samples fill it
  sample_cells(frame, place, rings.points, grey.data());
  const auto ring = static_cast<std::size_t>(4 * rings.width);
  const LightModel model{plane_through(grey.data(), rings, 0), plane_through(grey.data(), rings, ring)};
  const double middle = rings.width / 2.0;
  const double sign = light_inside ? -1 : 1;
  if (sign * (model.outside.at(middle, middle) - model.inside.at(middle, middle)) < least_contrast) {
    return std::nullopt;
  }
  const double level = model.inside.level + model.outside.level;
  const double du = model.inside.du + model.outside.du;
  const double dv = model.inside.dv + model.outside.dv;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < ring; ++i) {
    const double both =
        level + du * static_cast<double>(rings.points.u[i]) + dv * static_cast<double>(rings.points.v[i]);
    if (sign * (both - 2 * static_cast<double>(grey[i])) <= 0) ++wrong;
  }
  if (wrong > ring / static_cast<std::size_t>(one_in)) return std::nullopt;
  return model;
}

void LightModel::make_relative(const CellPoints& points, float* values) const {
  const auto level = static_cast<float>(inside.level);
  const auto du = static_cast<float>(inside.du);
  const auto dv = static_cast<float>(inside.dv);
  const auto rise = static_cast<float>(outside.level - inside.level);
  const auto rise_du = static_cast<float>(outside.du - inside.du);
  const auto rise_dv = static_cast<float>(outside.dv - inside.dv);
  const float* u = points.u.data();
  const float* v = points.v.data();
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = (values[i] - (level + du * u[i] + dv * v[i])) / (rise + rise_du * u[i] + rise_dv * v[i]);
  }
}

}  // namespace runmark
