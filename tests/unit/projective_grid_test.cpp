#include "pattern/projective_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "corner/quad.h"
#include "pattern/homography.h"

namespace runmark {
namespace {

TEST(ProjectiveGrid, AgreesWithTheHomography) {
  std::mt19937 random(5);
  int placed = 0;
  for (int round = 0; round < 2000; ++round) {
    const int size = 100 + static_cast<int>(random() % 6000);  // sixteenths
    const auto jitter = [&] {
      return static_cast<int>(random() % static_cast<unsigned>(size / 2)) - size / 4;
    };
    const int left = static_cast<int>(random() % 2000);
    std::array<SubpixelPoint, 4> corners{
        {{left, 500}, {left + size, 500}, {left + size, 500 + size}, {left, 500 + size}}};
    for (SubpixelPoint& c : corners) c = {c.x + jitter(), c.y + jitter()};
    const int width = 6 + static_cast<int>(random() % 5);
    const auto grid = ProjectiveGrid::make(corners, width);
    std::array<Point, 4> exact;
    for (std::size_t i = 0; i < 4; ++i) exact[i] = {corners[i].x + 0.0, corners[i].y + 0.0};
    ASSERT_EQ(grid.has_value(), is_convex_clockwise(exact));
    if (!grid) continue;
    const Homography homography(exact, width);
    for (int row = 0; row < width; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto p = grid->middle(column, row);
        ASSERT_TRUE(p);
        const Point q = homography(column + 0.5, row + 0.5);
        ASSERT_NEAR(p->x, q.x, 1.5 + size / 2000.0) << "in sixteenths";
        ASSERT_NEAR(p->y, q.y, 1.5 + size / 2000.0);
        ++placed;
      }
    }
  }
  EXPECT_GT(placed, 10000);
}

TEST(ProjectiveGrid, CornersThatAreNotConvexAreRefused) {
  EXPECT_TRUE(ProjectiveGrid::make({{{0, 0}, {160, 0}, {160, 160}, {0, 160}}}, 8));
  EXPECT_FALSE(ProjectiveGrid::make({{{0, 0}, {0, 160}, {160, 160}, {160, 0}}}, 8)) << "anticlockwise";
  EXPECT_FALSE(ProjectiveGrid::make({{{0, 0}, {160, 0}, {30, 30}, {0, 160}}}, 8)) << "dented";
  EXPECT_FALSE(ProjectiveGrid::make({{{0, 0}, {160, 0}, {320, 0}, {0, 160}}}, 8)) << "three on a line";
}

TEST(ProjectiveGrid, BeyondTheHorizonThereIsNothing) {
  // The plane comes towards the camera on the left and passes it one cell beyond the left side.
  const auto grid = ProjectiveGrid::make({{{0, 0}, {1600, 720}, {1600, 880}, {0, 1600}}}, 8);
  ASSERT_TRUE(grid);
  EXPECT_TRUE(grid->middle(-1, 4));
  EXPECT_FALSE(grid->middle(-2, 4));
}

}  // namespace
}  // namespace runmark
