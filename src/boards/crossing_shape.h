#pragma once

namespace runmark {

/// What the corners of the two drawings add: quarter planes that look like the plain squares.
struct CrossingDrawings {
  double from_u = 0;  // distance of their edges from the upright edge, in pixels
  double from_v = 0;
  bool on_diagonal = false;  // they are in the squares to the right below and the left above
};

/// A value between -1 and 1 and its derivatives by u, v and the width.
struct CrossingShape {
  double value;
  double by_u;
  double by_v;
  double by_width;
};

/// Two steps from -1 to 1 multiplied, blurred alike, with the drawings.
/// @param u, v   distances from the upright and from the level edge, in pixels
/// @param width  standard deviation of the blur, in pixels
[[nodiscard]] CrossingShape shape_of_crossing(double u, double v, double width,
                                              const CrossingDrawings& drawings);

}  // namespace runmark
