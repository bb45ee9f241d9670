#pragma once

#include "corner/quad_from_chain.h"
#include "pipeline/contour_scan.h"
#include "runmark/options.h"
#include "threshold/tiles.h"

namespace runmark {

/// What the default pipeline tells the cores at one of its scales.
struct ScaleRules {
  TileRule tiles;
  ContourRules contours;
  QuadLimits quads;
};

/// @param level  how often the rows have been halved
/// @param holes  whether light squares are looked for too
[[nodiscard]] ScaleRules scale_rules(const Options& options, int level, bool holes);

/// Whether a scale of this size is looked at; full size always is.
[[nodiscard]] bool scale_is_used(int level, int width, int height);

}  // namespace runmark
