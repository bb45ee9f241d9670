#include "pattern/integer_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/picture.h"

namespace runmark {
namespace {

Dictionary dictionary(const char* name) {
  auto loaded = builtin_dictionary(name);
  EXPECT_TRUE(loaded) << loaded.error();
  return *loaded;
}

IntegerQuad quad_at(const std::array<Point, 4>& corners, bool light_inside = false) {
  IntegerQuad quad;
  quad.light_inside = light_inside;
  for (std::size_t i = 0; i < 4; ++i) {
    quad.corners[i] = {static_cast<int>(std::lround(corners[i].x * 16)),
                       static_cast<int>(std::lround(corners[i].y * 16))};
  }
  return quad;
}

TEST(GreyBetween, LiesBetweenItsFourPixels) {
  test::Picture picture(4, 3, 10);
  picture.at(1, 1) = 20;
  picture.at(2, 1) = 60;
  picture.at(1, 2) = 100;
  picture.at(2, 2) = 200;
  const GreyFrame frame = picture.frame();
  EXPECT_EQ(grey_between(frame, 2, {16, 16}), 16 * 20);
  EXPECT_EQ(grey_between(frame, 2, {24, 16}), 16 * 40);
  EXPECT_EQ(grey_between(frame, 2, {16, 24}), 16 * 60);
  EXPECT_EQ(grey_between(frame, 2, {24, 24}), 16 * 95);
  EXPECT_EQ(grey_between(frame, 2, {-50, -50}), 16 * 10) << "the nearest pixel beyond the frame";
  EXPECT_EQ(grey_between(frame, 2, {200, 16}), 16 * 10);
  EXPECT_EQ(grey_between(frame, 1, {24, 40}), 16 * 40) << "rows that are not in";
}

TEST(IntegerLight, FindsAPlane) {
  for (int width = 6; width <= 10; ++width) {
    IntegerLight light(width);
    // Black 480 and white 2400 in the middle, both with the same slopes.
    const auto plane = [&](int column, int row) {
      return 12 * (2 * column + 1 - width) - 7 * (2 * row + 1 - width);
    };
    for (int row = -1; row <= width; ++row) {
      for (int column = -1; column <= width; ++column) {
        const bool beyond_row = row < 0 || row == width;
        const bool beyond_column = column < 0 || column == width;
        if (beyond_row && beyond_column) continue;
        const bool edge = row == 0 || column == 0 || row == width - 1 || column == width - 1;
        if (beyond_row || beyond_column) {
          light.add(column, row, 2400 + plane(column, row));
        } else if (edge) {
          light.add(column, row, 480 + plane(column, row));
        }
      }
    }
    light.finish();
    EXPECT_NEAR(light.contrast(), 1920, 4) << width;
    for (int i = 0; i < width; ++i) {
      EXPECT_NEAR(light.above(i, 2, 1440 + plane(i, 2)), 0, 4) << width;
      EXPECT_NEAR(light.above(3, i, 2400 + plane(3, i)), 960, 4) << width;
    }
  }
}

TEST(IntegerReader, ReadsEveryRotationAndWidth) {
  for (const char* name : {"DICT_4X4_50", "DICT_5X5_50", "DICT_6X6_50", "DICT_7X7_50", "tag16h5", "tag36h11",
                           "DICT_ARUCO_ORIGINAL", "ARUCO_MIP_36h12"}) {
    const Dictionary d = dictionary(name);
    ASSERT_TRUE(IntegerReader::can_read(d)) << name;
    const std::vector<Dictionary> all{d};
    const IntegerReader reader(all, {});
    for (const double size : {14.0, 60.0}) {
      for (int turn = 0; turn < 4; ++turn) {
        const auto corners = test::turned_square({50.2, 49.7}, size * (d.width / 8.0), 33 + 90 * turn);
        test::Picture picture(100, 100, 200);
        test::draw_at(picture, d, 7, corners);
        // The reader sees the corners from the topmost on, wherever the marker's first is.
        const auto seen = test::turned_square({50.2, 49.7}, size * (d.width / 8.0), 33);
        const auto reading = reader.read(picture.frame(), 99, quad_at(seen));
        ASSERT_TRUE(reading) << name << " " << size << " px, turned " << turn;
        EXPECT_EQ(reading->match.id, 7) << name;
        EXPECT_EQ(reading->match.rotation, turn) << name;
        EXPECT_EQ(reading->match.hamming, 0) << name;
        EXPECT_GT(reading->clearance * 5, reading->scale) << name << ": margin";
        EXPECT_LE(reading->clearance * 2, reading->scale) << name;
      }
    }
  }
}

TEST(IntegerReader, UnevenLightAndInverted) {
  const Dictionary d = dictionary("tag36h11");
  const std::vector<Dictionary> all{d};
  const IntegerReader reader(all, {});
  const auto corners = test::turned_square({50, 50}, 56, 12);
  for (const bool inverted : {false, true}) {
    test::Picture picture(100, 100, inverted ? 30 : 220);
    test::draw_at(picture, d, 42, corners, inverted);
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        picture.at(x, y) = static_cast<std::uint8_t>(picture.at(x, y) * (30 + 2 * x) / 240);
      }
    }
    const auto reading = reader.read(picture.frame(), 99, quad_at(corners, inverted));
    ASSERT_TRUE(reading) << inverted;
    EXPECT_EQ(reading->match.id, 42);
    EXPECT_EQ(reading->match.hamming, 0);
    EXPECT_FALSE(reader.read(picture.frame(), 99, quad_at(corners, !inverted))) << "the wrong way round";
  }
}

TEST(IntegerReader, WrongBordersAndFlatPicturesAreRefused) {
  const Dictionary d = dictionary("tag36h11");
  const auto corners = test::turned_square({50, 50}, 64, 0);
  test::Picture picture(100, 100, 220);
  const IntegerQuad quad = quad_at(corners);
  EXPECT_FALSE(read_cells(picture.frame(), 99, quad, 8)) << "no contrast";
  test::draw_at(picture, d, 0, corners);
  EXPECT_TRUE(read_cells(picture.frame(), 99, quad, 8));
  const auto whiten = [&](int cells) {
    for (int y = 18; y < 26; ++y) {
      for (int x = 18; x < 18 + 8 * cells; ++x) picture.at(x, y) = 220;
    }
  };
  whiten(3);
  EXPECT_TRUE(read_cells(picture.frame(), 99, quad, 8)) << "three white cells of the border";
  whiten(4);
  EXPECT_FALSE(read_cells(picture.frame(), 99, quad, 8)) << "four";
}

TEST(IntegerReader, TheFewestWrongBitsWin) {
  // Of two dictionaries with the same cells the one that holds the code exactly.
  const Dictionary mip = dictionary("ARUCO_MIP_36h12");
  const Dictionary tag = dictionary("tag36h11");
  const std::vector<Dictionary> all{mip, tag};
  const IntegerReader reader(all, {});
  const auto corners = test::turned_square({50, 50}, 56, 5);
  test::Picture picture(100, 100, 220);
  test::draw_at(picture, tag, 99, corners);
  const auto reading = reader.read(picture.frame(), 99, quad_at(corners));
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->dictionary, &all[1]);
  EXPECT_EQ(reading->match.id, 99);
  const IntegerReader strict(all, {.min_margin = 129});
  EXPECT_FALSE(strict.read(picture.frame(), 99, quad_at(corners))) << "no margin is above a half";
}

TEST(IntegerReader, OtherLayoutsItCannotRead) {
  for (const char* name : {"tagStandard41h12", "tagCircle21h7", "tagCustom48h12"}) {
    EXPECT_FALSE(IntegerReader::can_read(dictionary(name))) << name;
  }
}

}  // namespace
}  // namespace runmark
