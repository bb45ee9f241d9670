#pragma once

#include <string>
#include <vector>

#include "render/plane.h"
#include "render/rng.h"
#include "render/scene.h"
#include "runmark/dictionary.h"

namespace runmark::render {

/// A number drawn anew for each scene or marker. `skew` above 1 prefers low values, below 1 high ones.
struct Range {
  double low = 0;
  double high = 0;
  double skew = 1;
  [[nodiscard]] double draw(Rng& rng) const;
};

/// Something that happens in a share of the scenes only.
struct Sometimes {
  double chance = 0;
  Range range;
  [[nodiscard]] double draw(Rng& rng) const { return rng.chance(chance) ? range.draw(rng) : 0; }
};

/// So many markers of these sizes in each scene, on average.
struct SizeQuota {
  double low = 0;  ///< square root of the black square's area in the image, pixels
  double high = 0;
  double count = 1;
};

/// What the wall behind everything is made of.
enum class Wall : std::uint8_t { any, plaster, gradient, noise, foliage, brick, wood, tiles, checker, photo };

/// What the scenes of a set have in common: how each of their properties is drawn.
struct Recipe {
  int width = 640;
  int height = 480;
  std::vector<SizeQuota> sizes;
  double marker_free = 0;     ///< share of scenes without a marker
  Range tilt{0, 70};          ///< degrees
  Range margin{0.4, 3, 1.5};  ///< white paper round the marker, cells
  bool inverted = false;
  double occluded = 0.3;        ///< markers with a covered border in each scene, on average
  double cut = 0.2;             ///< markers cut by the picture's edge, likewise
  double board = 0;             ///< share of scenes with a sheet of markers or a chessboard of them
  Range board_size{14, 60, 2};  ///< of each of its markers, pixels
  double repeated = 0.05;       ///< share of markers that repeat the id of the one before
  Wall wall = Wall::any;
  Range clutter{2, 16};        ///< things on the wall
  Range level{0.3, 1.2, 0.5};  ///< light that four fifths of the picture stay below, as if the camera had
                               ///< measured it; 1 makes a perfect white full scale
  Range gradient{0, 0.6, 2};   ///< share of light gained or lost from the centre to an edge
  Sometimes lamps{0.25, {1, 2.99}};
  Sometimes shadows{0.5, {1, 3.99, 1.5}};
  Sometimes vignette{0.3, {0.05, 0.5}};
  Sometimes distortion{0.25, {-0.1, 0.03, 0.5}};
  Range focal{0.75, 1.5};   ///< of the width
  Range blur{0.3, 2.5, 3};  ///< standard deviation, pixels
  Sometimes motion{0.2, {1, 8, 2}};
  Range noise{0.5, 8, 2};  ///< grey levels at level 128
  double gamma = 1;
  Sometimes jpeg{0.4, {50, 96}};
};

/// The scene number `index` of the recipe: a function of recipe, dictionary, seed and index alone, so that
/// a few scenes of a set are a fair sample of it. `photos` are for Wall::photo and may be empty otherwise.
[[nodiscard]] Scene make_scene(const Recipe& recipe, const Dictionary& dictionary, std::uint64_t seed,
                               int index, const std::vector<std::shared_ptr<const Plane>>& photos = {});

}  // namespace runmark::render
