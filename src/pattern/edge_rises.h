#pragma once

namespace runmark {

/// Grey level rises between neighbouring pixels across one side of a quadrilateral, on up to most_lines rows
/// or columns of pixels. Positions are counted across the side, in pixels from the straight side.
// Much of it is not used for most sides, so it is not cleared.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct EdgeRises {
  static constexpr int most_lines = 24;
  static constexpr int most_rises = 40;

  int lines = 0;
  int rises = 0;                       ///< on every line
  float first[most_lines];             ///< where each line's first rise is; the others follow a pixel apart
  float rise[most_rises][most_lines];  ///< of all lines at a time, outwards to white
};

/// Weight and weighted position of each line's rises.
struct EdgeMoments {
  float weight[EdgeRises::most_lines];
  float sum[EdgeRises::most_lines];
};

/// Weighs every rise within `reach` of the straight side by its square: the strongest edge counts most.
void square_moments(const EdgeRises& rises, float reach, EdgeMoments& moments);

/// Weighs the rises in a window `width` to both sides of where the edge is taken to be, `offset` on each
/// line; positions count from there. A rise that the window cuts counts in part.
/// @return the sum of cut rises times their distance
float window_moments(const EdgeRises& rises, const float* offset, float width, EdgeMoments& moments);

/// Rises of all lines, falls taken off, in a window about the edge.
float window_sum(const EdgeRises& rises, const float* offset, float width);

}  // namespace runmark
