// What detectors get wrong on single markers: several kinds at once, very large ones, copies, touching ones,
// cut and covered ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/scene.h"
#include "render/standard_sets.h"
#include "runmark/detector.h"
#include "support/corners.h"
#include "support/picture.h"

namespace runmark {
namespace {

using test::worst_corner;

Dictionary dictionary(const char* name) {
  auto loaded = builtin_dictionary(name);
  EXPECT_TRUE(loaded) << loaded.error();
  return *loaded;
}

std::vector<Marker> markers_in(const test::Picture& picture, std::vector<Dictionary> dictionaries,
                               Options options = {}) {
  options.max_width = picture.width();
  options.max_height = picture.height();
  auto detector = Detector::create(options, std::move(dictionaries));
  EXPECT_TRUE(detector) << detector.error();
  const Detection found = detector->detect(picture.view());
  EXPECT_EQ(found.status, Status::ok);
  std::vector<Marker> markers(found.begin(), found.end());
  for (Marker& marker : markers) marker.dictionary = {};  // the detector's memory
  return markers;
}

/// Puts a marker upright, its black square's top-left pixel at (x, y), white cells round it.
std::array<Point, 4> put(test::Picture& picture, const Dictionary& d, std::size_t id, int x, int y, int cell,
                         int margin) {
  const MarkerDrawing drawing = draw_marker(d, id, cell, margin);
  for (int j = 0; j < drawing.side; ++j) {
    for (int i = 0; i < drawing.side; ++i) {
      const int px = x - drawing.origin + i;
      const int py = y - drawing.origin + j;
      if (px < 0 || py < 0 || px >= picture.width() || py >= picture.height()) continue;
      const int grey = drawing.grey[static_cast<std::size_t>(j) * static_cast<std::size_t>(drawing.side) +
                                    static_cast<std::size_t>(i)];
      picture.at(px, py) = static_cast<std::uint8_t>(30 + grey * 190 / 255);
    }
  }
  const double left = x - 0.5;
  const double top = y - 0.5;
  const double right = left + drawing.square;
  const double bottom = top + drawing.square;
  return {Point{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

TEST(HardCases, InvertedAndPlainMarkersInOnePass) {
  const Dictionary d = dictionary("tag36h11");
  test::Picture picture(320, 160, 120);
  test::draw_at(picture, d, 3, test::turned_square({80.2, 80.4}, 64, 10), false);
  test::draw_at(picture, d, 4, test::turned_square({240.7, 79.1}, 64, -17), true);
  const auto found = markers_in(picture, {d}, {.inverted = true});
  ASSERT_EQ(found.size(), 2U);
  for (const Marker& marker : found) {
    EXPECT_TRUE(marker.id == 3 || marker.id == 4);
    EXPECT_EQ(marker.inverted, marker.id == 4);
  }
}

TEST(HardCases, MarkersOfMoreThanAThousandPixels) {
  const Dictionary d = dictionary("tag36h11");
  test::Picture picture(1500, 1400, 200);
  const auto truth = put(picture, d, 77, 150, 120, 150, 1);
  const auto found = markers_in(picture, {d});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].id, 77);
  EXPECT_LT(worst_corner(found[0], truth), 0.1);
}

TEST(HardCases, InAlmostNoLight) {
  const Dictionary d = dictionary("tag36h11");
  test::Picture picture(160, 160, 200);
  const auto truth = test::turned_square({80.2, 80.4}, 72, 10);
  test::draw_at(picture, d, 3, truth, false);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.at(x, y) = static_cast<std::uint8_t>(2 + picture.at(x, y) / 20);
    }
  }
  const auto found = markers_in(picture, {d});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].id, 3);
  EXPECT_LT(worst_corner(found[0], truth), 0.3);
}

TEST(HardCases, StrongerEdgesBesideTheMarker) {
  const Dictionary d = dictionary("tag36h11");
  const render::StandardSet* set = render::find_standard_set("vga");
  for (const auto& [scene, id] : {std::pair(120, 264), std::pair(130, 461)}) {
    const render::RenderedFrame frame =
        render::render(render::make_scene(set->recipe, d, render::set_seed("vga", 0), scene));
    auto detector = Detector::create({.max_width = frame.width, .max_height = frame.height}, {d});
    ASSERT_TRUE(detector) << detector.error();
    const Detection found =
        detector->detect(ImageView::grey(frame.grey.data(), frame.width, frame.height, frame.width));
    EXPECT_EQ(std::ranges::count(found, id, &Marker::id), 1) << scene;
  }
}

TEST(HardCases, BothCopiesOfOneId) {
  const Dictionary d = dictionary("DICT_6X6_250");
  test::Picture picture(200, 100, 220);
  put(picture, d, 9, 12, 20, 6, 1);
  put(picture, d, 9, 112, 24, 6, 1);
  const auto found = markers_in(picture, {d});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, 9);
  EXPECT_EQ(found[1].id, 9);
  EXPECT_GT(std::fabs(found[0].corners[0].x - found[1].corners[0].x), 90);
}

TEST(HardCases, OneMarkerIsReportedOnceAtAnySize) {
  const Dictionary d = dictionary("tag25h9");
  for (int side = 16; side <= 320; side += side / 4) {
    test::Picture picture(400, 400, 210);
    test::draw_at(picture, d, 5, test::turned_square({200.3, 199.6}, side, 0.3 * side));
    const auto found = markers_in(picture, {d}, {.inverted = true, .octaves = 3});
    ASSERT_EQ(found.size(), 1U) << side;
    EXPECT_EQ(found[0].id, 5) << side;
  }
}

TEST(HardCases, MarkersThatTouchAtCorners) {
  const Dictionary d = dictionary("DICT_4X4_50");
  // A chessboard whose black squares are markers: each touches four others at its corners.
  for (const int cell : {3, 5, 9}) {
    const int pitch = 6 * cell;
    test::Picture picture(6 * pitch, 6 * pitch, 220);
    int placed = 0;
    for (int row = 0; row < 4; ++row) {
      for (int column = row % 2; column < 4; column += 2) {
        put(picture, d, static_cast<std::size_t>(placed++), (column + 1) * pitch, (row + 1) * pitch, cell, 0);
      }
    }
    const auto found = markers_in(picture, {d});
    EXPECT_EQ(found.size(), static_cast<std::size_t>(placed)) << cell;
  }
}

TEST(HardCases, CutByTheEdgeRightOrNotAtAll) {
  const Dictionary d = dictionary("tag36h11");
  int reported = 0;
  for (const double degrees : {0.0, 8.0, 33.0}) {
    for (int shift = -30; shift <= 46; shift += 4) {
      const auto truth = test::turned_square({shift + 0.3, 50.2}, 60, degrees);
      test::Picture picture(120, 100, 190);
      test::draw_at(picture, d, 11, truth);
      for (const Marker& marker : markers_in(picture, {d})) {
        ++reported;
        EXPECT_EQ(marker.id, 11) << degrees << ' ' << shift;
        EXPECT_LT(worst_corner(marker, truth), 3) << degrees << ' ' << shift;
      }
    }
  }
  EXPECT_GT(reported, 5) << "those inside the picture";
}

TEST(HardCases, ACoveredCornerNeverChangesTheId) {
  const Dictionary d = dictionary("tag36h11");
  int reported = 0;
  for (const double cover : {30.0, 110.0, 220.0}) {
    for (double radius = 0; radius <= 24; radius += 4) {
      for (const double degrees : {0.0, 21.0}) {
        const auto truth = test::turned_square({70.3, 69.6}, 80, degrees);
        test::Picture picture(140, 140, 190);
        test::draw_at(picture, d, 12, truth);
        const Point corner = truth[1];
        picture.draw([&](double x, double y) {
          return std::hypot(x - corner.x, y - corner.y) < radius ? cover : -1.0;
        });
        for (const Marker& marker : markers_in(picture, {d})) {
          ++reported;
          EXPECT_EQ(marker.id, 12) << cover << ' ' << radius;
          if (radius > 4) continue;
          EXPECT_LT(worst_corner(marker, truth), 4) << cover << ' ' << radius << ' ' << degrees;
        }
      }
    }
  }
  EXPECT_GT(reported, 12) << "those with little covered";
}

TEST(HardCases, TheLargerCodeWinsAmongSeveralDictionaries) {
  const Dictionary large = dictionary("tag36h11");
  const Dictionary small = dictionary("DICT_4X4_1000");
  test::Picture picture(900, 640, 210);
  int placed = 0;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 12; ++column) {
      put(picture, large, static_cast<std::size_t>(placed++), 14 + column * 74, 14 + row * 78, 6, 1);
    }
  }
  Options options;
  options.max_width = picture.width();
  options.max_height = picture.height();
  auto detector = Detector::create(options, {small, large});
  ASSERT_TRUE(detector) << detector.error();
  const Detection found = detector->detect(picture.view());
  EXPECT_EQ(found.markers.size(), static_cast<std::size_t>(placed));
  for (const Marker& marker : found) EXPECT_EQ(marker.dictionary, "tag36h11") << marker.id;
}

}  // namespace
}  // namespace runmark
