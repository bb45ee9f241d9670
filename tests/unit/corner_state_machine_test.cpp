#include "corner/corner_state_machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "corner/quad.h"
#include "support/chains.h"
#include "support/picture.h"

namespace runmark {
namespace {

using Corners = std::optional<std::array<CrackPoint, 4>>;

Corners corners_of(int size, const auto& dark, int threshold = 5) {
  Corners corners;
  test::follow_contours(size, size, dark,
                        [&](const ClosedChain& chain) { corners = four_corners(chain, threshold); });
  return corners;
}

Corners corners_of_square(double side, double degrees) {
  const auto truth = test::turned_square({100.2, 99.7}, side, degrees);
  return corners_of(200, [&](int x, int y) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (cross(truth[i], truth[(i + 1) % 4], {static_cast<double>(x), static_cast<double>(y)}) < 0)
        return false;
    }
    return true;
  });
}

TEST(CornerStateMachine, UprightSquareClockwiseFromWhereItClosed) {
  const auto corners = corners_of(100, [](int x, int y) { return x >= 20 && x < 60 && y >= 30 && y < 80; });
  ASSERT_TRUE(corners);
  std::array<CrackPoint, 4> sorted = *corners;
  const auto first = std::find(sorted.begin(), sorted.end(), CrackPoint{20, 30});
  ASSERT_NE(first, sorted.end());
  std::rotate(sorted.begin(), first, sorted.end());
  EXPECT_EQ(sorted, (std::array<CrackPoint, 4>{{{20, 30}, {60, 30}, {60, 80}, {20, 80}}}));
}

TEST(CornerStateMachine, AnOffsetOfTheThresholdMakesACorner) {
  const auto square = [](int x, int y) { return x >= 10 && x < 17 && y >= 10 && y < 17; };
  EXPECT_TRUE(corners_of(30, square, 7));
  EXPECT_FALSE(corners_of(30, square, 8));
}

TEST(CornerStateMachine, SuitsNearUprightSquaresOnly) {
  // A side of 50 px drifts by the threshold of 5 px at 5.7 degrees; past that corners are false.
  for (const double degrees : {0.0, 1.0, 3.0, 4.5, -4.5, 90.0, 183.0}) {
    const auto corners = corners_of_square(50, degrees);
    ASSERT_TRUE(corners) << degrees;
    const auto truth = test::turned_square({100.2, 99.7}, 50, degrees);
    for (const Point& t : truth) {
      const bool near = std::any_of(corners->begin(), corners->end(), [&](CrackPoint c) {
        return std::hypot(c.x - 0.5 - t.x, c.y - 0.5 - t.y) <
               5.5;  // the threshold may fall short within one run
      });
      EXPECT_TRUE(near) << degrees;
    }
  }
  EXPECT_FALSE(corners_of_square(50, 30));
  EXPECT_FALSE(corners_of_square(50, 45));
}

TEST(CornerStateMachine, CountsExactlyFour) {
  const auto letter = corners_of(
      100, [](int x, int y) { return x > 20 && y > 20 && x < 80 && y < 80 && (x < 50 || y > 50); });
  EXPECT_FALSE(letter) << "six corners";
  const auto speck = corners_of(100, [](int x, int y) { return x >= 60 && x < 63 && y >= 60 && y < 63; });
  EXPECT_FALSE(speck) << "sides shorter than the threshold";
}

}  // namespace
}  // namespace runmark
