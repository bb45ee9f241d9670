#pragma once

#include <cstddef>
#include <vector>

#include "pattern/grey_frame.h"
#include "pattern/homography.h"

namespace runmark {

/// Points of a marker in cells from its top-left corner, kept as coordinates side by side so that many are
/// looked at at a time.
struct CellPoints {
  /// Samples come in groups of so many: arrays of samples need room for whole groups.
  static constexpr std::size_t group = 16;

  std::vector<float> u;
  std::vector<float> v;

  void add(double cell_u, double cell_v) {
    u.push_back(static_cast<float>(cell_u));
    v.push_back(static_cast<float>(cell_v));
  }
  [[nodiscard]] std::size_t size() const { return u.size(); }
};

/// Bilinear grey levels at all points, as by GreyFrame::sample; beyond the frame the nearest pixel counts.
/// @param grey  room for size() rounded up to whole groups
void sample_cells(const GreyFrame& frame, const Homography& place, const CellPoints& points, float* grey);

}  // namespace runmark
