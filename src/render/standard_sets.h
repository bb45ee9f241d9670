#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "render/recipe.h"

namespace runmark::render {

/// A set of scenes with a name: anybody who renders it gets the same pictures.
struct StandardSet {
  std::string_view name;
  int scenes = 0;
  Recipe recipe;
};

/// vga, hd, fullhd and uhd: sizes of 8 to 200 pixels and more in equal shares.
[[nodiscard]] std::span<const StandardSet> standard_sets();

/// Null when there is none of that name.
[[nodiscard]] const StandardSet* find_standard_set(std::string_view name);

/// The seed of a set's scenes: `seed` 0 is the standard one.
[[nodiscard]] std::uint64_t set_seed(std::string_view name, std::uint64_t seed);

/// The limits of the size buckets, in pixels; the last one has no upper limit.
[[nodiscard]] std::span<const double> size_buckets();

}  // namespace runmark::render
