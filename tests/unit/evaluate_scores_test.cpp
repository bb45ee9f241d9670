#include "evaluate/scores.h"

#include <gtest/gtest.h>

#include <sstream>

#include "evaluate/buckets.h"
#include "evaluate/report.h"
#include "render/standard_sets.h"

namespace runmark {
namespace {

Corners square(double x, double y, double side) {
  return {Point{x, y}, Point{x + side, y}, Point{x + side, y + side}, Point{x, y + side}};
}

// Two images: a marker of 20 px found 3 px right and 4 px below, one of 50 px missed; a false alarm.
std::vector<TruthImage> truth() {
  TruthImage first{.image = "a.png", .width = 640, .height = 480, .dictionary = "tag36h11"};
  first.markers.push_back({.id = 1, .corners = square(10, 10, 50), .exact_corners = true, .tilt = 20});
  first.markers.push_back({.id = 2, .corners = square(200, 10, 20), .exact_corners = true, .tilt = 40});
  first.present_ids = {1, 2};
  return {first, TruthImage{.image = "b.png", .width = 640, .height = 480}};
}

Observations observations() {
  return {{"a.png", {{{1, square(13, 14, 50)}}, 5.0}}, {"b.png", {{{3, square(5, 5, 20)}}, 7.0}}};
}

const Tally& row(const Scores& scores, const std::string& name, const std::string& label) {
  for (const Breakdown& b : scores.breakdowns) {
    for (const auto& [l, tally] : b.rows) {
      if (b.name == name && l == label) return tally;
    }
  }
  static const Tally none{.truth = -1};
  return none;
}

TEST(Scores, CountsAndSplits) {
  const Scores scores = score(truth(), observations());
  EXPECT_EQ(scores.images, 2U);
  EXPECT_EQ(scores.total.truth, 2);
  EXPECT_EQ(scores.total.found, 1);
  EXPECT_EQ(scores.total.false_alarms, 1);
  EXPECT_EQ(row(scores, "size", "48-64").found, 1);
  EXPECT_EQ(row(scores, "size", "16-24").found, 0);
  EXPECT_EQ(row(scores, "size", "16-24").truth, 1);
  EXPECT_EQ(row(scores, "tilt", "15-30").found, 1);
  EXPECT_EQ(row(scores, "dictionary", "none").false_alarms, 1);
  EXPECT_EQ(row(scores, "noise", "<1").truth, -1) << "nothing is known of the noise";
}

TEST(Scores, MeasuresCorners) {
  const CornerErrors& corners = score(truth(), observations()).total.corners;
  EXPECT_EQ(corners.count(), 4U);
  EXPECT_DOUBLE_EQ(corners.rms(), 5);
  EXPECT_DOUBLE_EQ(corners.percentile(0.95), 5);
  EXPECT_DOUBLE_EQ(corners.bias().x, 3);
  EXPECT_DOUBLE_EQ(corners.bias().y, 4);
  EXPECT_NEAR(corners.outward_bias(), 0, 1e-12) << "shifted, not grown";
}

TEST(Scores, ListsMistakesAndTimes) {
  const Scores scores = score(truth(), observations());
  ASSERT_EQ(scores.mistakes.size(), 2U);
  EXPECT_EQ(scores.mistakes[0].kind, Mistake::Kind::missed);
  EXPECT_EQ(scores.mistakes[0].id, 2);
  EXPECT_EQ(scores.mistakes[1].kind, Mistake::Kind::false_alarm);
  EXPECT_EQ(scores.milliseconds, (std::vector{5.0, 7.0}));
}

TEST(Scores, AnImageNobodyLookedAtHasItsMarkersMissed) {
  EXPECT_EQ(score(truth(), {}).total.found, 0);
  EXPECT_EQ(score(truth(), {}).total.truth, 2);
}

TEST(Scores, ReportsSayTheSameInEveryFormat) {
  const Scores scores = score(truth(), observations());
  std::ostringstream text;
  std::ostringstream csv;
  std::ostringstream json;
  write_text(text, scores);
  write_csv(csv, scores);
  write_json(json, scores);
  EXPECT_NE(text.str().find("recall 0.5000 (1/2)  false 1 "), std::string::npos) << text.str();
  EXPECT_NE(csv.str().find("total,,2,1,0.5000,0,0,1,0,0,5.0000,"), std::string::npos) << csv.str();
  EXPECT_NE(json.str().find("\"corner_rms\": 5.0"), std::string::npos) << json.str();
}

TEST(Buckets, HoldTheirLowerEdge) {
  const Buckets buckets{1, 2.5};
  EXPECT_EQ(buckets.label(buckets.place(0.9)), "<1");
  EXPECT_EQ(buckets.label(buckets.place(1)), "1-2.5");
  EXPECT_EQ(buckets.label(buckets.place(2.5)), ">=2.5");
}

TEST(Buckets, AreThoseOfTheStandardSets) {
  std::size_t place = 0;
  for (const double edge : render::size_buckets()) EXPECT_EQ(size_buckets.place(edge), ++place);
  EXPECT_EQ(size_buckets.count(), place + 1);
}

}  // namespace
}  // namespace runmark
