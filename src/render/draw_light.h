#pragma once

#include "render/recipe.h"

namespace runmark::render {

/// Light as the recipe has it, its level set as a camera would have metered it.
[[nodiscard]] Light draw_light(const Recipe& recipe, Rng& rng);

}  // namespace runmark::render
