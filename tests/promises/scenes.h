#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "render/recipe.h"
#include "render/scene.h"
#include "render/standard_sets.h"
#include "runmark/detector.h"

namespace runmark::test {

inline Dictionary dictionary(const std::string& name) {
  auto loaded = builtin_dictionary(name);
  EXPECT_TRUE(loaded) << loaded.error();
  return *std::move(loaded);
}

inline Detector make_detector(Options options, int width, int height) {
  options.max_width = width;
  options.max_height = height;
  auto made = Detector::create(options, {dictionary("tag36h11")});
  EXPECT_TRUE(made) << made.error();
  return *std::move(made);
}

/// A scene of a standard set, with tag36h11.
inline render::RenderedFrame scene_of(const char* set_name, int index) {
  const render::StandardSet* set = render::find_standard_set(set_name);
  return render::render(
      render::make_scene(set->recipe, dictionary("tag36h11"), render::set_seed(set_name, 0), index));
}

/// A scene of large markers out of focus, which only the half sizes show.
inline render::RenderedFrame blurred_scene(int index) {
  render::Recipe recipe = render::find_standard_set("hd")->recipe;
  recipe.sizes = {{100, 350, 4}};
  recipe.blur = {3, 9, 1};
  recipe.tilt = {0, 45, 1};
  recipe.motion.chance = 0;
  return render::render(render::make_scene(recipe, dictionary("tag36h11"), 1, index));
}

inline ImageView view_of(const render::RenderedFrame& frame) {
  return ImageView::grey(frame.grey.data(), frame.width, frame.height, frame.width);
}

/// The hardest frame there is for fixed memory: every pixel black or white by chance.
inline std::vector<std::uint8_t> binary_noise(int width, int height) {
  std::mt19937 random(3);
  std::vector<std::uint8_t> grey(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint8_t& value : grey) value = (random() & 1U) != 0 ? 255 : 0;
  return grey;
}

}  // namespace runmark::test
