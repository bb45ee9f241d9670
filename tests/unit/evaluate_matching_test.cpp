#include "evaluate/matching.h"

#include <gtest/gtest.h>

namespace runmark {
namespace {

Corners square(double x, double y, double side) {
  return {Point{x, y}, Point{x + side, y}, Point{x + side, y + side}, Point{x, y + side}};
}

Corners turned(const Corners& c) { return {c[1], c[2], c[3], c[0]}; }

TruthImage one_marker() {
  TruthImage image;
  image.markers.push_back({.id = 7, .corners = square(100, 100, 50)});
  image.maybe.push_back({.id = 8, .corners = square(300, 100, 50)});
  image.present_ids = {7, 8, 9};
  return image;
}

using enum MarkerMatch::Outcome;

TEST(Matching, FindsAMarkerAndItsErrors) {
  const std::vector<Observation> seen{{7, square(101, 100, 50)}};
  const ImageMatch result = match(one_marker(), seen);
  EXPECT_EQ(result.markers[0].outcome, found);
  EXPECT_EQ(result.markers[0].rotation, 0);
  EXPECT_DOUBLE_EQ(result.markers[0].error[2].x, 1);
  EXPECT_DOUBLE_EQ(result.markers[0].error[2].y, 0);
  EXPECT_EQ(result.reports[0], ReportKind::matched);
}

TEST(Matching, ToleratesATenthOfTheSideButNotLessThanThreePixels) {
  const auto outcome = [](double side, double shift) {
    TruthImage image;
    image.markers.push_back({.id = 7, .corners = square(100, 100, side)});
    Corners corners = square(100, 100, side);
    corners[0].x -= shift;
    return match(image, std::vector<Observation>{{7, corners}}).markers[0].outcome;
  };
  EXPECT_EQ(outcome(100, 9.9), found);
  EXPECT_EQ(outcome(100, 10.1), bad_corner);
  EXPECT_EQ(outcome(12, 2.9), found);
  EXPECT_EQ(outcome(12, 3.1), bad_corner);
}

TEST(Matching, SeesRotations) {
  Corners corners = square(100, 100, 50);
  for (const int rotation : {0, 3, 2, 1}) {
    const ImageMatch result = match(one_marker(), std::vector<Observation>{{7, corners}});
    EXPECT_EQ(result.markers[0].outcome, found);
    EXPECT_EQ(result.markers[0].rotation, rotation);
    EXPECT_DOUBLE_EQ(result.markers[0].error[0].x, 0);
    corners = turned(corners);
  }
}

TEST(Matching, TellsReportsApart) {
  const std::vector<Observation> seen{
      {7, square(102, 100, 50)},  // worse than the next
      {7, square(101, 100, 50)}, {8, square(300, 100, 50)},
      {9, square(10, 10, 50)},   {10, square(100, 100, 50)},
  };
  const ImageMatch result = match(one_marker(), seen);
  EXPECT_EQ(result.markers[0].observation, 1);
  EXPECT_EQ(result.reports, (std::vector{ReportKind::duplicate, ReportKind::matched, ReportKind::duplicate,
                                         ReportKind::extra, ReportKind::false_alarm}));
}

TEST(Matching, GivesAReportToOneOfTwoCopiesOnly) {
  TruthImage image = one_marker();
  image.markers.push_back({.id = 7, .corners = square(110, 100, 50)});
  const ImageMatch result = match(image, std::vector<Observation>{{7, square(105, 100, 50)}});
  EXPECT_EQ(result.markers[0].observation, 0);
  EXPECT_EQ(result.markers[1].outcome, missed);
}

}  // namespace
}  // namespace runmark
