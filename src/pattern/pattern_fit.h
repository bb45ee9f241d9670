#pragma once

#include <array>

#include "pattern/cell_samples.h"
#include "pattern/grey_frame.h"
#include "pattern/light_model.h"
#include "pattern/pattern_picture.h"
#include "runmark/marker.h"

namespace runmark {

/// What fitting a pattern came to.
struct PatternFit {
  std::array<Point, 4> corners{};
  double explained = 0;   ///< share of what varies in the frame that the picture explains, 1 for all
  bool is_sharp = false;  ///< the edges are too sharp for places half a cell apart to tell where they are
};

/// Moves the corners of a marker whose cells are known to where its blurred picture is nearest to the frame,
/// by Gauss and Newton's method for the homography, black, white, and the blur along both sides. All edges
/// between cells count, and blur, which bends the outline, is explained. The corners stay where the picture
/// leads nowhere.
/// @param places   picture_places(cells.width)
/// @param corners  of the cells' square, a fraction of a cell from the truth
[[nodiscard]] PatternFit fit_pattern(const GreyFrame& frame, const PatternCells& cells,
                                     const CellPoints& places, const LightModel& light,
                                     const std::array<Point, 4>& corners);

}  // namespace runmark
