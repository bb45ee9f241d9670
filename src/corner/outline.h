#pragma once

#include <cstddef>
#include <vector>

#include "runmark/marker.h"

namespace runmark {

/// The vertices of a chain's polygon, clockwise in the image: crack x and crack line y, kept as coordinates
/// side by side so that many are looked at at a time. Whole numbers below 65536 are exact.
struct Outline {
  explicit Outline(std::size_t most) : x(most + slack), y(most + slack) {}

  /// Room behind the vertices for the rest of a vector.
  static constexpr std::size_t slack = 16;

  std::vector<float> x;
  std::vector<float> y;
  std::size_t count = 0;
};

/// A vertex in the coordinates of pixels: crack x lies half a pixel before the middle of pixel x.
[[nodiscard]] inline Point crack_point(const Outline& outline, std::size_t vertex) {
  return {static_cast<double>(outline.x[vertex]) - 0.5, static_cast<double>(outline.y[vertex]) - 0.5};
}

/// The first vertex of those farthest from vertex `from`.
[[nodiscard]] std::size_t farthest_from(const Outline& outline, std::size_t from);

struct BothSides {
  std::size_t right = 0;
  std::size_t left = 0;
};

/// The vertices farthest from the line a -> b on its right hand and on its left hand in the image; `a` where
/// there is none. Of several as far, the first.
[[nodiscard]] BothSides farthest_from_line(const Outline& outline, std::size_t a, std::size_t b);

}  // namespace runmark
