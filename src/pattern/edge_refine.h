#pragma once

#include "corner/quad.h"
#include "pattern/grey_frame.h"

namespace runmark {

/// Fits each side of the quadrilateral anew to the grey-level edge beneath it and puts the corners where
/// neighbouring lines meet. The side is looked for within `reach` pixels on both sides, each sample of it
/// at the middle of its grey-level gradient. Sides without a clear edge stay as they are.
/// @param quad   corners in pixels of `frame`
/// @param cells  cells along a side: the search stays within the border cell
/// @param reach  how far the edge may lie from the quadrilateral, in pixels
[[nodiscard]] Quad refine_edges(const GreyFrame& frame, const Quad& quad, int cells, double reach);

}  // namespace runmark
