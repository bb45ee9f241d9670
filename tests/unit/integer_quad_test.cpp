#include "corner/integer_quad.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "corner/chain_extremes.h"
#include "corner/quad.h"
#include "corner/side_fit.h"
#include "support/chains.h"
#include "support/corners.h"
#include "support/picture.h"

namespace runmark {
namespace {

using test::Corners;
using test::inside;
using test::worst_corner;

Corners in_pixels(const IntegerQuad& quad) {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = in_pixels(quad.corners[i]);
  return corners;
}

std::vector<IntegerQuad> quads_of(int width, int height, const auto& dark) {
  std::vector<IntegerQuad> quads;
  test::follow_contours(width, height, dark, [&](const ClosedChain& chain) {
    if (const auto quad = integer_quad(chain, {})) quads.push_back(*quad);
  });
  return quads;
}

TEST(IntegerQuad, SquareAtEveryAngle) {
  double squares = 0;
  for (int degrees = 0; degrees < 360; degrees += 3) {
    const auto truth = test::turned_square({60.3, 59.6}, 50, degrees);
    const auto quads = quads_of(120, 120, [&](int x, int y) { return inside(truth, x, y); });
    ASSERT_EQ(quads.size(), 1U) << degrees;
    EXPECT_FALSE(quads[0].light_inside);
    EXPECT_TRUE(is_convex_clockwise(in_pixels(quads[0])));
    const double worst = worst_corner(truth, in_pixels(quads[0]));
    EXPECT_LT(worst, 0.9) << degrees;
    squares += worst * worst;
  }
  EXPECT_LT(std::sqrt(squares / 120), 0.45) << "of a binary picture, worst corner of each";
}

TEST(IntegerQuad, SmallSquaresAtEveryAngle) {
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const auto truth = test::turned_square({30.3, 29.6}, 11, degrees);
    const auto quads = quads_of(60, 60, [&](int x, int y) { return inside(truth, x, y); });
    ASSERT_EQ(quads.size(), 1U) << degrees;
    EXPECT_LT(worst_corner(truth, in_pixels(quads[0])), 1.5) << degrees;
  }
}

TEST(ChainExtremes, AreTheFirstVerticesFarthestInEachDirection) {
  constexpr std::array<std::array<int, 2>, 8> directions{
      {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}}};
  const auto shape = [](int x, int y) { return x >= 5 && x < 25 && y >= 5 && y < 25 && x + y < 44; };
  test::follow_contours(40, 40, shape, [&](const ClosedChain& chain) {
    std::vector<NumberedVertex> vertices;
    chain.runs([&](int from, int to, int y) {
      vertices.push_back({from, y, static_cast<int>(vertices.size())});
      vertices.push_back({to, y, static_cast<int>(vertices.size())});
    });
    const ChainExtremes extremes = chain_extremes(chain);
    for (std::size_t i = 0; i < 16; ++i) {
      const int dx = directions[i % 8][0];
      const int dy = directions[i % 8][1];
      const int sign = i < 8 ? 1 : -1;
      const auto first = std::ranges::max_element(
          vertices, {}, [&](const NumberedVertex& v) { return sign * (dx * v.x + dy * v.y); });
      EXPECT_EQ(extremes.farthest[i].number, first->number) << "direction " << i;
    }
  });
}

TEST(SideFit, SlopeAndPlaceAreThoseOfTheLine) {
  constexpr int length = 64;
  for (const double slope : {0.0, 0.25, -0.4, 0.9}) {
    const int end = static_cast<int>(std::lround(length * slope));
    SideFit fit({0, 40, 0}, {length, 40 + end, 2 * length});
    for (int x = 0; x < length; ++x) {
      fit.add_horizontal(x, x + 1, 40 + static_cast<int>(std::lround((x + 0.5) * slope)));
    }
    const auto line = fit.line();
    ASSERT_TRUE(line) << slope;
    constexpr double one = 1 << IntegerLine::slope_bits;
    EXPECT_NEAR(line->slope / one, slope, 0.008);
    const double x = in_pixels(line->at).x + 0.5;  // of the crack
    EXPECT_NEAR(in_pixels(line->at).y + 0.5, 40 + x * slope, 0.15) << slope;
  }
}

TEST(IntegerQuad, LimitsAreIncluded) {
  const auto square = [](int x, int y) { return x >= 10 && x < 18 && y >= 10 && y < 18; };
  const auto found_with = [&](const IntegerQuadLimits& limits) {
    int found = 0;
    test::follow_contours(30, 30, square, [&](const ClosedChain& chain) {
      found += integer_quad(chain, limits).has_value() ? 1 : 0;
    });
    return found;
  };
  EXPECT_EQ(found_with({.min_area = 64, .max_area = 64, .min_side = 8}), 1);
  EXPECT_EQ(found_with({.min_area = 65, .max_area = 1000, .min_side = 3}), 0);
  EXPECT_EQ(found_with({.min_area = 25, .max_area = 63, .min_side = 3}), 0);
  EXPECT_EQ(found_with({.min_area = 25, .max_area = 1000, .min_side = 9}), 0);
}

TEST(IntegerQuad, PerspectiveAndHole) {
  const Corners truth{{{20, 30}, {100, 12}, {90, 80}, {35, 105}}};
  const auto dark = quads_of(120, 120, [&](int x, int y) { return inside(truth, x, y); });
  ASSERT_EQ(dark.size(), 1U);
  EXPECT_LT(worst_corner(truth, in_pixels(dark[0])), 0.8);
  const auto hole = quads_of(
      120, 120, [&](int x, int y) { return x > 3 && y > 3 && x < 116 && y < 116 && !inside(truth, x, y); });
  ASSERT_EQ(hole.size(), 2U) << "the dark square round it closes last";
  EXPECT_TRUE(hole[0].light_inside);
  EXPECT_TRUE(is_convex_clockwise(in_pixels(hole[0]))) << "a hole's corners go clockwise too";
  EXPECT_LT(worst_corner(truth, in_pixels(hole[0])), 0.8);
}

TEST(IntegerQuad, AWholeFrameOfTheLargestSize) {
  // The sums are the largest they can be.
  const Corners truth{{{8, 10}, {3830, 5}, {3835, 2150}, {3, 2144}}};
  const auto quads = quads_of(3840, 2160, [&](int x, int y) { return inside(truth, x, y); });
  ASSERT_EQ(quads.size(), 1U);
  EXPECT_LT(worst_corner(truth, in_pixels(quads[0])), 1);
}

TEST(IntegerQuad, OtherShapesAreRefused) {
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
  EXPECT_TRUE(quads_of(120, 120, speck).empty());
}

TEST(ChainExtremes, AreaAndFarthestVertices) {
  int chains = 0;
  const auto rectangle = [](int x, int y) { return x >= 5 && x < 25 && y >= 7 && y < 17; };
  test::follow_contours(40, 40, rectangle, [&](const ClosedChain& chain) {
    ++chains;
    const ChainExtremes extremes = chain_extremes(chain);
    EXPECT_EQ(extremes.area, 200);
    EXPECT_EQ(extremes.farthest[2].x, 25) << "right and down";
    EXPECT_EQ(extremes.farthest[2].y, 17);
    EXPECT_EQ(extremes.farthest[14].x, 25) << "right and up";
    EXPECT_EQ(extremes.farthest[14].y, 7);
    const auto corners = widest_corners(extremes);
    ASSERT_TRUE(corners);
    int turned = 0;  // the corners go clockwise, beginning anywhere
    while (turned < 4 && ((*corners)[static_cast<std::size_t>(turned)].x != 5 ||
                          (*corners)[static_cast<std::size_t>(turned)].y != 7)) {
      ++turned;
    }
    ASSERT_LT(turned, 4);
    EXPECT_EQ((*corners)[static_cast<std::size_t>(turned + 1) % 4].x, 25);
    EXPECT_EQ((*corners)[static_cast<std::size_t>(turned + 1) % 4].y, 7);
  });
  EXPECT_EQ(chains, 1);
}

TEST(SideFit, FindsTheLineOfAStaircase) {
  // Slope 1/8: a crack column every pixel, a step every eight.
  SideFit fit({0, 10, 0}, {80, 20, 7});
  for (int i = 0; i < 10; ++i) fit.add_horizontal(8 * i, 8 * i + 8, 10 + i);
  const auto line = fit.line();
  ASSERT_TRUE(line);
  EXPECT_TRUE(line->across);
  EXPECT_NEAR(line->slope, (1 << 14) / 8, 40);
  // At column 40 the steps' mean is 14.5 cracks, 14 pixels.
  EXPECT_NEAR(line->at.y + line->slope * (16 * 40 - 8 - line->at.x) / double{1 << 14}, 16 * 14, 2);
}

TEST(SideFit, DirectionAndFoldsDoNotMatter) {
  SideFit there({0, 10, 0}, {80, 20, 7});
  SideFit back({80, 20, 0}, {0, 10, 7});
  SideFit folded({0, 10, 0}, {80, 20, 7});
  for (int i = 0; i < 10; ++i) {
    there.add_horizontal(8 * i, 8 * i + 8, 10 + i);
    back.add_horizontal(8 * (9 - i) + 8, 8 * (9 - i), 10 + 9 - i);
    folded.add_horizontal(8 * i, 8 * i + 8, 10 + i);
  }
  folded.add_horizontal(40, 70, 16);
  folded.add_horizontal(70, 40, 16);
  ASSERT_TRUE(there.line() && back.line() && folded.line());
  EXPECT_EQ(there.line()->slope, folded.line()->slope);
  EXPECT_EQ(there.line()->at, folded.line()->at);
  EXPECT_NEAR(there.line()->slope, back.line()->slope, 1);
  EXPECT_NEAR(there.line()->at.y, back.line()->at.y, 1);
}

TEST(SideFit, ABentSideHasNoLine) {
  SideFit bent({0, 10, 0}, {80, 10, 7});
  bent.add_horizontal(0, 40, 10);
  bent.add_horizontal(40, 80, 40);
  EXPECT_FALSE(bent.line());
}

TEST(IntegerLines, Meet) {
  constexpr int one = 1 << 14;
  const IntegerLine level{true, {160, 320}, 0};
  const IntegerLine upright{false, {480, 80}, 0};
  const IntegerLine rising{true, {0, 0}, one / 2};
  const auto expect_at = [](std::optional<SubpixelPoint> found, SubpixelPoint place) {
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, place.x, 1) << "in sixteenths";
    EXPECT_NEAR(found->y, place.y, 1);
  };
  expect_at(meet(level, upright), {480, 320});
  expect_at(meet(upright, level), {480, 320});
  expect_at(meet(level, rising), {640, 320});
  expect_at(meet(rising, level), {640, 320});
  EXPECT_FALSE(meet(level, IntegerLine{true, {0, 0}, one / 32})) << "nearly parallel";
  EXPECT_FALSE(meet(rising, rising));
}

}  // namespace
}  // namespace runmark
