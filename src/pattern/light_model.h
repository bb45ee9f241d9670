#pragma once

#include <optional>

#include "pattern/cell_samples.h"
#include "pattern/grey_frame.h"
#include "pattern/homography.h"

namespace runmark {

/// A grey level that varies linearly over the marker: value at cell coordinates (u, v).
struct GreyPlane {
  double level = 0;
  double du = 0;
  double dv = 0;
  [[nodiscard]] double at(double u, double v) const { return level + du * u + dv * v; }
};

/// What black and white look like over a marker, fitted to the ring of cells just inside the square and
/// the ring just outside it.
struct LightModel {
  GreyPlane inside;
  GreyPlane outside;

  /// From grey levels at points to 0 where they are like the ring inside the square and 1 where they are like
  /// that outside.
  void make_relative(const CellPoints& points, float* values) const;
};

/// The middles of the cells just inside the square of a marker, along its four sides, and behind them those
/// of the cells just outside.
struct BorderRings {
  static constexpr int most_width = 16;  ///< cells across the square

  explicit BorderRings(int cells_across);

  int width;
  CellPoints points;
};

/// Samples both rings. Nothing when more than one in `one_in` cells of the ring inside is not on its side of
/// the middle level: then the quadrilateral is no marker's border.
[[nodiscard]] std::optional<LightModel> fit_light(const GreyFrame& frame, const Homography& place,
                                                  const BorderRings& rings, bool light_inside, int one_in);

}  // namespace runmark
