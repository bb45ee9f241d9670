#pragma once

#include <cstdint>

#include "pattern/grey_frame.h"
#include "pattern/homography.h"
#include "pattern/light_model.h"
#include "pattern/marker_layout.h"

namespace runmark {

/// What the data cells say.
struct CellReading {
  std::uint64_t code = 0;  ///< the first cell is the most significant bit; 1 like the ring outside the square
  float margin = 0;        ///< as Marker::margin
};

/// Samples the data cells and takes each for dark or light.
[[nodiscard]] CellReading read_cells(const GreyFrame& frame, const Homography& place, const LightModel& light,
                                     const MarkerLayout& layout);

/// The lightest of the data cells, by its middle: 0 like the ring inside the square, 1 like that outside.
[[nodiscard]] float lightest_cell(const GreyFrame& frame, const Homography& place, const LightModel& light,
                                  const MarkerLayout& layout);

}  // namespace runmark
