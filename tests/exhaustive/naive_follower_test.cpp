#include "naive_follower.h"

#include <gtest/gtest.h>

namespace runmark {
namespace {

TEST(NaiveFollower, SquareWithAHole) {
  PixelImage image(3, 3);
  image.set_all(0b111'101'111);
  NaiveContours found;
  NaiveFollower().follow(image, Connectivity::eight, found);
  ASSERT_EQ(found.contours.size(), 2U);
  EXPECT_FALSE(found.contours[0].hole);
  EXPECT_EQ(found.contours[0].count, 2U);
  EXPECT_EQ(found.contours[0].turns, 2U);
  EXPECT_TRUE(found.contours[1].hole);
  EXPECT_EQ(found.contours[1].top, 1);
  EXPECT_EQ(found.contours[1].bottom, 2);
}

TEST(NaiveFollower, DiagonalPairIsOneObjectOrTwo) {
  PixelImage image(2, 2);
  for (const std::uint64_t pair : {0b1001U, 0b0110U}) {
    image.set_all(pair);
    NaiveContours found;
    NaiveFollower follower;
    follower.follow(image, Connectivity::eight, found);
    ASSERT_EQ(found.contours.size(), 1U);
    EXPECT_EQ(found.contours[0].count, 4U);
    EXPECT_EQ(found.contours[0].turns, 2U);
    follower.follow(image, Connectivity::four, found);
    EXPECT_EQ(found.contours.size(), 2U);
  }
}

TEST(NaiveFollower, CombTurnsTenTimes) {
  PixelImage image(9, 2);
  image.set_all(0b111111111'101010101);
  NaiveContours found;
  NaiveFollower().follow(image, Connectivity::eight, found);
  ASSERT_EQ(found.contours.size(), 1U);
  EXPECT_EQ(found.contours[0].count, 10U);
  EXPECT_EQ(found.contours[0].turns, 10U);
}

}  // namespace
}  // namespace runmark
