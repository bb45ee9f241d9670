// Every contender reports in our conventions: id, corner order, pixel centres.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/peers/reader.h"
#include "evaluate/matching.h"
#include "evaluate/tally.h"
#include "render/recipe.h"
#include "render/standard_sets.h"

namespace runmark::bench {
namespace {

// Large, sharp, quiet markers without a lens: whoever misses most of them or puts their corners elsewhere is
// set up wrongly.
render::Recipe easy() {
  render::Recipe recipe = render::find_standard_set("vga")->recipe;
  recipe.sizes = {{60, 120, 4}};
  recipe.tilt = {0, 25};
  recipe.margin = {1.5, 2};
  recipe.marker_free = recipe.occluded = recipe.cut = recipe.repeated = 0;
  recipe.distortion.chance = recipe.motion.chance = recipe.jpeg.chance = recipe.shadows.chance = 0;
  recipe.lamps.chance = 0;
  recipe.wall = render::Wall::plaster;
  recipe.clutter = {0, 0};
  recipe.level = {0.7, 0.9};
  recipe.gradient = {0, 0.1};
  recipe.blur = {0.5, 0.8};
  recipe.noise = {0.5, 1};
  return recipe;
}

Tally tally_of(const Contender& contender, const Dictionary& dictionary, bool inverted) {
  render::Recipe recipe = easy();
  recipe.inverted = inverted;
  const auto reader = contender.make({{&dictionary, 1}, inverted, {recipe.width, recipe.height}});
  Tally tally;
  for (int scene = 0; scene < 4; ++scene) {
    const render::RenderedFrame frame = render::render(render::make_scene(recipe, dictionary, 5, scene));
    cv::Mat grey(frame.height, frame.width, CV_8UC1);
    std::ranges::copy(frame.grey, grey.begin<std::uint8_t>());
    TruthImage truth;
    for (const render::MarkerTruth& m : frame.truth.markers) {
      truth.markers.push_back({.id = m.id, .corners = m.corners, .exact_corners = true});
    }
    const ImageMatch matches = match(truth, reader->read(grey));
    for (std::size_t i = 0; i < truth.markers.size(); ++i) tally.add(truth.markers[i], matches.markers[i]);
    for (const ReportKind report : matches.reports) tally.add(report);
  }
  return tally;
}

void expect_our_conventions(const Contender& contender, const std::string& name, bool inverted = false) {
  const auto dictionary = builtin_dictionary(name);
  ASSERT_TRUE(dictionary) << dictionary.error();
  const Tally tally = tally_of(contender, *dictionary, inverted);
  const std::string who = std::string(contender.name) + " " + name;
  ASSERT_GT(tally.truth, 8) << who;
  // How many each finds is not the matter here; a wrong set-up finds none.
  EXPECT_GE(tally.found, tally.truth / 2) << who;
  EXPECT_EQ(tally.rotated, 0) << who << ": corner order";
  EXPECT_EQ(tally.false_alarms, 0) << who;
  EXPECT_LT(std::abs(tally.corners.bias().x), 0.2) << who << ": pixel centres";
  EXPECT_LT(std::abs(tally.corners.bias().y), 0.2) << who << ": pixel centres";
}

TEST(Contenders, ReportInOurConventions) {
  for (const Contender& contender : contenders()) {
    for (const char* name : {"tag36h11", "DICT_APRILTAG_25h9", "DICT_5X5_100", "ARUCO_MIP_36h12"}) {
      expect_our_conventions(contender, name);
    }
  }
}

TEST(Contenders, ReadWhiteOnBlack) {
  for (const Contender& contender : contenders()) expect_our_conventions(contender, "DICT_6X6_250", true);
}

TEST(Contenders, AprilTagReadsReversedFamilies) {
  expect_our_conventions(*find_contender("apriltag-1"), "tagStandard41h12");
}

TEST(Contenders, AreFoundByName) {
  EXPECT_EQ(find_contender("nobody"), nullptr);
  EXPECT_EQ(find_contender("opencv")->name, "opencv");
}

}  // namespace
}  // namespace runmark::bench
