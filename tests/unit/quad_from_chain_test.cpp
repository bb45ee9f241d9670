#include "corner/quad_from_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/chains.h"
#include "support/corners.h"
#include "support/picture.h"

namespace runmark {
namespace {

using test::inside;
using test::worst_corner;

std::vector<Quad> quads_of(int width, int height, const auto& dark) {
  std::vector<Quad> quads;
  Outline scratch(20000);
  test::follow_contours(width, height, dark, [&](const ClosedChain& chain) {
    if (const auto quad = quad_from_chain(chain, {}, scratch)) quads.push_back(*quad);
  });
  return quads;
}

TEST(QuadFromChain, SquareAtEveryAngle) {
  double squares = 0;
  for (int degrees = 0; degrees < 360; degrees += 3) {
    const auto truth = test::turned_square({60.3, 59.6}, 50, degrees);
    const auto quads = quads_of(120, 120, [&](int x, int y) { return inside(truth, x, y); });
    ASSERT_EQ(quads.size(), 1U) << degrees;
    EXPECT_FALSE(quads[0].light_inside);
    EXPECT_TRUE(is_convex_clockwise(quads[0].corners));
    const double worst = worst_corner(truth, quads[0].corners);
    EXPECT_LT(worst, 0.8) << degrees;
    squares += worst * worst;
  }
  EXPECT_LT(std::sqrt(squares / 120), 0.45) << "of a binary picture, worst corner of each";
}

TEST(QuadFromChain, PerspectiveAndHole) {
  const std::array<Point, 4> truth{{{20, 30}, {100, 12}, {90, 80}, {35, 105}}};
  const auto dark = quads_of(120, 120, [&](int x, int y) { return inside(truth, x, y); });
  ASSERT_EQ(dark.size(), 1U);
  EXPECT_LT(worst_corner(truth, dark[0].corners), 0.8);
  const auto hole = quads_of(
      120, 120, [&](int x, int y) { return x > 3 && y > 3 && x < 116 && y < 116 && !inside(truth, x, y); });
  ASSERT_EQ(hole.size(), 2U) << "the dark square round it closes last";
  EXPECT_TRUE(hole[0].light_inside);
  EXPECT_TRUE(is_convex_clockwise(hole[0].corners)) << "a hole's corners go clockwise too";
  EXPECT_LT(worst_corner(truth, hole[0].corners), 0.8);
}

TEST(QuadFromChain, OtherShapesAreRefused) {
  const auto disc = [](int x, int y) { return (x - 60) * (x - 60) + (y - 60) * (y - 60) < 1600; };
  EXPECT_TRUE(quads_of(120, 120, disc).empty());
  const auto triangle = [](int x, int y) {
    return y > 20 && y < 100 && x > 60 - (y - 20) / 2 && x < 60 + (y - 20) / 2;
  };
  EXPECT_TRUE(quads_of(120, 120, triangle).empty());
  const auto letter = [](int x, int y) {
    return x > 20 && y > 20 && x < 100 && y < 100 && (x < 50 || y > 70);
  };
  EXPECT_TRUE(quads_of(120, 120, letter).empty());
  const auto speck = [](int x, int y) { return x >= 60 && x < 63 && y >= 60 && y < 63; };
  EXPECT_TRUE(quads_of(120, 120, speck).empty()) << "smaller than min_area";
}

}  // namespace
}  // namespace runmark
