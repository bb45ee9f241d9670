#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/recipe.h"

namespace runmark::render {

/// Puts a wall over all of the picture and returns what it is made of, in a word.
std::string add_wall(Scene& scene, Wall wall, Rng& rng,
                     const std::vector<std::shared_ptr<const Plane>>& photos);

/// Hangs `count` things on it: posters, windows, shelves, boards with other codes, tiles, boxes.
void add_clutter(Scene& scene, int count, Rng& rng);

}  // namespace runmark::render
