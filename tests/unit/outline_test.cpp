#include "corner/outline.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

namespace runmark {
namespace {

Outline outline_of(std::initializer_list<std::pair<float, float>> vertices) {
  Outline outline(vertices.size());
  for (const auto& [x, y] : vertices) {
    outline.x[outline.count] = x;
    outline.y[outline.count] = y;
    ++outline.count;
  }
  return outline;
}

TEST(Outline, FarthestVertexIsTheFirstOfThoseAsFar) {
  const Outline square = outline_of({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {8, 8}});
  EXPECT_EQ(farthest_from(square, 0), 2U);
  EXPECT_EQ(farthest_from(square, 1), 3U);
}

TEST(Outline, FarthestVerticesOnEitherSideOfALine) {
  // Going right in the image, the right hand is below.
  const Outline kite = outline_of({{0, 5}, {4, 1}, {5, 0}, {10, 5}, {6, 7}, {5, 9}, {3, 6}});
  const BothSides sides = farthest_from_line(kite, 0, 3);
  EXPECT_EQ(sides.left, 2U);
  EXPECT_EQ(sides.right, 5U);
  const BothSides back = farthest_from_line(kite, 3, 0);
  EXPECT_EQ(back.left, 5U);
  EXPECT_EQ(back.right, 2U);
}

TEST(Outline, WhereASideIsEmptyTheLinesStartStandsIn) {
  const Outline triangle = outline_of({{0, 0}, {9, 0}, {4, 6}});
  const BothSides sides = farthest_from_line(triangle, 0, 1);
  EXPECT_EQ(sides.right, 2U);
  EXPECT_EQ(sides.left, 0U);
}

}  // namespace
}  // namespace runmark
