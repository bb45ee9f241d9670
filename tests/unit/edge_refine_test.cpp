#include "pattern/edge_refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/picture.h"

namespace runmark {
namespace {

TEST(Homography, TakesTheSquareToItsCorners) {
  const std::array<Point, 4> corners{{{20, 30}, {100, 12}, {90, 80}, {35, 105}}};
  const Homography map(corners, 8);
  const std::array<Point, 4> square{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = map(square[i].x, square[i].y);
    EXPECT_NEAR(p.x, corners[i].x, 1e-9);
    EXPECT_NEAR(p.y, corners[i].y, 1e-9);
  }
  // The middle goes to where the diagonals meet.
  const Point middle = map(4, 4);
  EXPECT_NEAR(cross(corners[0], corners[2], middle), 0, 1e-9);
  EXPECT_NEAR(cross(corners[1], corners[3], middle), 0, 1e-9);
}

TEST(RefineEdges, FindsTheEdgeFromAPixelAway) {
  for (const double degrees : {0.0, 7.0, 22.5, 43.0, 81.0}) {
    const auto truth = test::turned_square({60.25, 58.75}, 48, degrees);
    test::Picture picture(120, 120, 200);
    test::PlaneMap map(truth);
    picture.draw([&](double x, double y) {
      const Point uv = map(x, y);
      return uv.x > 0 && uv.y > 0 && uv.x < 1 && uv.y < 1 ? 40.0 : 200.0;
    });
    Quad start;
    start.corners = test::turned_square({60.9, 58.4}, 49.5, degrees + 0.7);
    const Quad refined = refine_edges(picture.frame(), start, 8, 2.5);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(refined.corners[i].x, truth[i].x, 0.05) << degrees;
      EXPECT_NEAR(refined.corners[i].y, truth[i].y, 0.05) << degrees;
    }
  }
}

TEST(RefineEdges, FindsSoftEdgesOfTenGreyLevels) {
  const auto truth = test::turned_square({60.25, 58.75}, 64, 22.5);
  test::Picture picture(120, 120, 14);
  test::PlaneMap map(truth);
  picture.draw([&](double x, double y) {
    // A ramp 6 pixels wide: no two pixels differ by more than 2.
    const Point uv = map(x, y);
    const double inside = 64 * std::min({uv.x, uv.y, 1 - uv.x, 1 - uv.y});
    return 14 - 10 * std::clamp(0.5 + inside / 6, 0.0, 1.0);
  });
  Quad start;
  start.corners = test::turned_square({61.2, 58.2}, 66, 23.5);
  const Quad refined = refine_edges(picture.frame(), start, 8, 5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(refined.corners[i].x, truth[i].x, 0.3);
    EXPECT_NEAR(refined.corners[i].y, truth[i].y, 0.3);
  }
}

TEST(RefineEdges, TakesNoNoiseForAnEdge) {
  // The dark square goes on to the rim of the frame: there is no edge above it.
  test::Picture picture(60, 60, 104);
  std::mt19937 random(5);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const bool dark = x >= 20 && x < 40 && y < 20;
      picture.at(x, y) = static_cast<std::uint8_t>((dark ? 26 : 104) + static_cast<int>(random() % 9) - 4);
    }
  }
  Quad start;
  start.corners = {{{19.5, -0.5}, {39.5, -0.5}, {39.5, 19.5}, {19.5, 19.5}}};
  const Quad refined = refine_edges(picture.frame(), start, 7, 2.5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(refined.corners[i].x, start.corners[i].x);
    EXPECT_EQ(refined.corners[i].y, start.corners[i].y);
  }
}

TEST(RefineEdges, LeavesAFlatFrameAlone) {
  const test::Picture picture(80, 80, 90);
  Quad start;
  start.corners = test::turned_square({40, 40}, 30, 10);
  const Quad refined = refine_edges(picture.frame(), start, 8, 2.5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(refined.corners[i].x, start.corners[i].x);
    EXPECT_EQ(refined.corners[i].y, start.corners[i].y);
  }
}

}  // namespace
}  // namespace runmark
