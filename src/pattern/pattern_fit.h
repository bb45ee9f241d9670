#pragma once

#include <array>
#include <optional>

#include "pattern/cell_samples.h"
#include "pattern/grey_frame.h"
#include "pattern/light_model.h"
#include "pattern/pattern_picture.h"
#include "runmark/marker.h"

namespace runmark {

/// Moves the corners of a marker whose cells are known to where its blurred picture is nearest to the frame,
/// by Gauss and Newton's method for the homography, black, white, and the blur along both sides. All edges
/// between cells count, and blur, which bends the outline, is explained.
/// @param places   picture_places(cells.width)
/// @param corners  of the cells' square, a fraction of a cell from the truth
/// @return nothing when the picture does not explain the frame, or the edges are too sharp for its places
[[nodiscard]] std::optional<std::array<Point, 4>> fit_pattern(const GreyFrame& frame,
                                                              const PatternCells& cells,
                                                              const CellPoints& places,
                                                              const LightModel& light,
                                                              const std::array<Point, 4>& corners);

}  // namespace runmark
