#include "pattern/square_grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace runmark {
namespace {

TEST(SquareGrid, All64PointsAtEveryAngle) {
  constexpr double side = 80;
  for (int degrees = 0; degrees < 360; ++degrees) {
    const double turn = degrees * std::acos(-1.0) / 180;
    const CrackPoint a{200, 200};
    const CrackPoint b{200 + static_cast<int>(std::lround(side * std::cos(turn))),
                       200 + static_cast<int>(std::lround(side * std::sin(turn)))};
    const double ux = b.x - a.x;
    const double uy = b.y - a.y;
    for (int row = 0; row < grid_side; ++row) {
      for (int column = 0; column < grid_side; ++column) {
        const double along = (column + 0.5) / grid_side;
        const double down = (row + 0.5) / grid_side;
        const PixelPosition p = grid_sample(a, b, column, row);
        // The pixel that holds the middle of the cell: crack x is the left side of pixel x.
        EXPECT_EQ(p.x, static_cast<int>(std::floor(a.x + along * ux - down * uy)));
        EXPECT_EQ(p.y, static_cast<int>(std::floor(a.y + along * uy + down * ux)));
      }
    }
  }
}

TEST(SquareGrid, UprightSquareReadsItsCells) {
  EXPECT_EQ(grid_sample({16, 32}, {80, 32}, 0, 0), (PixelPosition{20, 36}));
  EXPECT_EQ(grid_sample({16, 32}, {80, 32}, 7, 0), (PixelPosition{76, 36}));
  EXPECT_EQ(grid_sample({16, 32}, {80, 32}, 7, 7), (PixelPosition{76, 92}));
  EXPECT_EQ(grid_sample({16, 32}, {80, 32}, 0, 7), (PixelPosition{20, 92}));
}

}  // namespace
}  // namespace runmark
