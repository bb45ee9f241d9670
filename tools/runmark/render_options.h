#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/recipe.h"

namespace CLI {
class App;
}

namespace runmark::cli {

/// What `runmark render` was asked for. Empty strings, negative numbers: the set's own.
struct RenderOptions {
  std::string set = "vga";
  std::filesystem::path output;
  int scenes = 0;
  int first = 0;
  std::uint64_t seed = 0;
  std::string dictionary;
  std::string board;  ///< views of it instead of scenes; as load_board reads it
  bool inverted = false;
  std::string format;
  bool colour = false;
  int frames = 0;
  double fps = 30;
  double shake = 1;
  int jobs = 0;
  std::string picture_size;
  std::filesystem::path background;
  std::string wall;
  std::string marker_size;
  std::string tilt;
  std::string margin;
  std::string blur;
  std::string motion;
  std::string noise;
  std::string level;
  std::string gradient;
  std::string shadows;
  std::string lamps;
  std::string clutter;
  std::string distortion;
  std::string vignette;
  std::string jpeg;
  double occluded = -1;
  double cut = -1;
  double gamma = -1;
};

void add_render_options(CLI::App& command, RenderOptions& options);

/// The recipe with what the options change in it. Throws UserError for values out of range.
[[nodiscard]] render::Recipe recipe_of(const RenderOptions& options, render::Recipe recipe);

/// Throws UserError when the format does not go with the other options.
void check_format(const RenderOptions& options);

}  // namespace runmark::cli
