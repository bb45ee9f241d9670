#pragma once

#include "render/rng.h"
#include "render/scene.h"
#include "runmark/dictionary.h"

namespace runmark::render {

/// What a scene with one marker is drawn from.
struct PosedMarkerRanges {
  double smallest = 12;  ///< square root of the marker's area in the picture, pixels
  double largest = 260;
  double most_tilt = 65;  ///< degrees
  double most_blur = 2.5;
  double most_noise = 8;
  double jpeg = 0.25;    ///< chance of a compressed picture
  double motion = 0.15;  ///< chance of a shaken one
};

/// One marker on paper before a plain wall, in a picture that is just large enough, seen by a camera whose
/// focal length is 700 pixels: cheap to render by the thousand. The marker's surface is the last one; its
/// unit is a cell, and its pose is exact.
[[nodiscard]] Scene posed_marker(const Dictionary& dictionary, const PosedMarkerRanges& ranges, Rng& rng);

}  // namespace runmark::render
