#pragma once

#include <span>
#include <string_view>

#include "render/recipe.h"

namespace runmark::render {

/// A scene to show: one picture of what is hard in practice.
struct Sample {
  std::string_view name;
  std::string_view dictionary;
  Recipe recipe;
  std::uint64_t seed = 1;
};

/// Eight scenes of 1280x720 for demonstrations.
[[nodiscard]] std::span<const Sample> samples();

}  // namespace runmark::render
