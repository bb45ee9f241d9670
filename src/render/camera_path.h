#pragma once

#include "render/scene.h"

namespace runmark::render {

/// The scene as a hand-held camera sees it `seconds` later: it sways, turns and comes nearer and goes back,
/// smoothly and without end. `strength` 1 turns it by up to 6 degrees; 0 leaves the scene as it is but for
/// the noise, which is new in every frame.
[[nodiscard]] Scene after(const Scene& scene, double seconds, double strength);

}  // namespace runmark::render
