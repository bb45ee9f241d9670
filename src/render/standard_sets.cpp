#include "render/standard_sets.h"

#include <algorithm>
#include <array>

namespace runmark::render {

namespace {

constexpr std::array buckets{8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 100.0, 200.0};

// One marker of each bucket in each scene, and `more` of those that fit in larger pictures.
Recipe recipe(int width, int height, double more) {
  Recipe r;
  r.width = width;
  r.height = height;
  r.marker_free = 0.08;
  r.board = 0.15;
  for (std::size_t i = 0; i + 1 < buckets.size(); ++i) {
    r.sizes.push_back({buckets[i], buckets[i + 1], i >= 2 ? 1 + more : 1});
  }
  r.sizes.push_back({200, std::max(260.0, 0.5 * height), 1});
  r.clutter = {2, 16 + 8 * more};
  return r;
}

const std::array<StandardSet, 4> sets{
    StandardSet{"vga", 300, recipe(640, 480, 0)}, StandardSet{"hd", 250, recipe(1280, 720, 0.5)},
    StandardSet{"fullhd", 250, recipe(1920, 1080, 1)}, StandardSet{"uhd", 250, recipe(3840, 2160, 2)}};

}  // namespace

std::span<const StandardSet> standard_sets() { return sets; }

const StandardSet* find_standard_set(std::string_view name) {
  const auto found =
      std::find_if(sets.begin(), sets.end(), [&](const StandardSet& s) { return s.name == name; });
  return found == sets.end() ? nullptr : &*found;
}

std::uint64_t set_seed(std::string_view name, std::uint64_t seed) { return mix(hash(name) + seed); }

std::span<const double> size_buckets() { return buckets; }

}  // namespace runmark::render
