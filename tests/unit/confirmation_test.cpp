#include "runmark/confirmation.h"

#include <gtest/gtest.h>

#include <string>

namespace runmark {
namespace {

Marker at(int id, double x, double y, double side = 40, const char* dictionary = "tag36h11") {
  Marker marker;
  marker.dictionary = dictionary;
  marker.id = id;
  marker.corners = {Point{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  return marker;
}

/// The ids that count, as a word.
std::string ids(std::span<const Marker> markers) {
  std::string text;
  for (const Marker& marker : markers) text += std::to_string(marker.id) + " ";
  return text;
}

using Frame = std::vector<Marker>;

TEST(Confirmation, AMarkerCountsFromItsThirdFrameOn) {
  Confirmation confirmation(3);
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 10, 10)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 12, 10)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(2, 200, 10), at(1, 15, 10)})), "1 ");
  const std::span<const Marker> found = confirmation.next(Frame{at(2, 200, 10), at(1, 18, 10)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].corners[0].x, 18) << "as found, where it is now";
  EXPECT_EQ(ids(confirmation.next(Frame{at(2, 201, 10), at(1, 20, 10)})), "2 1 ") << "in the order found";
}

TEST(Confirmation, OneFrameLetsEverythingThrough) {
  Confirmation confirmation(1);
  EXPECT_EQ(ids(confirmation.next(Frame{at(5, 0, 0), at(6, 9, 9)})), "5 6 ");
}

TEST(Confirmation, FramesWithoutItInBetween) {
  Confirmation confirmation(3);
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 10, 10)})), "");
  EXPECT_EQ(ids(confirmation.next({})), "");
  EXPECT_EQ(ids(confirmation.next({})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 10, 10)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 10, 10)})), "1 ") << "two missed frames are forgiven";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(ids(confirmation.next({})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 10, 10)})), "") << "three are not";
}

TEST(Confirmation, ItMayMoveByItsSideInEachFrame) {
  Confirmation confirmation(3);
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 39, 0)})), "");
  EXPECT_EQ(ids(confirmation.next({})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 118, 0)})), "1 ");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 300, 0)})), "") << "elsewhere it begins anew";
}

TEST(Confirmation, ChanceFindsOfAnIdInDifferentPlacesNeverCount) {
  Confirmation confirmation(2);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(ids(confirmation.next(Frame{at(1, i % 3 * 200.0, 0)})), "");
}

TEST(Confirmation, TwoCopiesOfAnIdAreTwo) {
  Confirmation confirmation(2);
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0), at(1, 30, 0)})), "1 ") << "the nearer one goes on";
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0), at(1, 30, 0)})), "1 1 ");
}

TEST(Confirmation, DictionariesAreKeptApartAndANewVideoBeginsAnew) {
  Confirmation confirmation(2);
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0, 40, "tag25h9")})), "");
  confirmation.restart();
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0)})), "");
  EXPECT_EQ(ids(confirmation.next(Frame{at(1, 0, 0)})), "1 ");
}

TEST(Confirmation, MoreMarkersThanItCanFollowAreLeftOut) {
  Confirmation confirmation(1);
  Frame many(5000, at(1, 0, 0));
  for (int i = 0; i < 5000; ++i) many[static_cast<std::size_t>(i)].id = i;
  EXPECT_EQ(confirmation.next(many).size(), 4096U);
  EXPECT_EQ(confirmation.next(Frame{at(0, 0, 0)}).size(), 1U);
}

}  // namespace
}  // namespace runmark
