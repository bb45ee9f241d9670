#include "render/draw_light.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "render/maths.h"

namespace runmark::render {

namespace {

// Scales the light to what the camera would have chosen.
void expose_to(Light& light, double level, int width, int height) {
  constexpr int columns = 16;
  constexpr int rows = 12;
  std::vector<double> sample;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      sample.push_back(light.at({(i + 0.5) * width / columns, (j + 0.5) * height / rows}, width, height));
    }
  }
  const auto fourth_fifth = sample.begin() + std::ptrdiff_t{columns} * rows * 4 / 5;
  std::nth_element(sample.begin(), fourth_fifth, sample.end());
  const double factor = level / *fourth_fifth;
  light.level *= factor;
  for (Lamp& lamp : light.lamps) lamp.strength *= factor;
}

}  // namespace

Light draw_light(const Recipe& recipe, Rng& rng) {
  Light light;
  light.level = 1;
  const double gradient = recipe.gradient.draw(rng);
  const double direction = rng.uniform(0, 2 * pi);
  light.slope_x = gradient * cosine(direction);
  light.slope_y = gradient * sine(direction);
  light.vignette = recipe.vignette.draw(rng);
  const auto anywhere = [&] { return Point{rng.uniform(0, recipe.width), rng.uniform(0, recipe.height)}; };
  for (int n = static_cast<int>(recipe.lamps.draw(rng)); n > 0; --n) {
    light.lamps.push_back({anywhere(), rng.uniform(0.1, 0.6), recipe.width * rng.uniform(0.1, 0.5)});
  }
  for (int n = static_cast<int>(recipe.shadows.draw(rng)); n > 0; --n) {
    Shadow s;
    s.shape = static_cast<Shadow::Shape>(rng.below(4));
    s.place = anywhere();
    s.direction = rng.uniform(0, 2 * pi);
    s.size = recipe.width * rng.uniform(0.02, 0.3);
    // Hard ones from the sun, soft ones from lamps and windows.
    s.softness = rng.chance(0.5) ? rng.uniform(0.7, 3) : recipe.width * rng.uniform(0.01, 0.1);
    s.depth = rng.uniform(0.15, 0.6);
    light.shadows.push_back(s);
  }
  expose_to(light, recipe.level.draw(rng), recipe.width, recipe.height);
  return light;
}

}  // namespace runmark::render
