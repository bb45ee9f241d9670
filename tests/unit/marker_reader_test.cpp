#include "pattern/marker_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/picture.h"

namespace runmark {
namespace {

const auto corners = test::turned_square({50.3, 49.8}, 60, 12);

/// The reader refers to them.
std::vector<Dictionary> list_of(Result<Dictionary> dictionary) {
  EXPECT_TRUE(dictionary);
  return {*std::move(dictionary)};
}

Quad quad_at(const std::array<Point, 4>& at, bool light_inside = false) {
  Quad quad;
  quad.corners = at;
  quad.light_inside = light_inside;
  return quad;
}

/// A black square on the white frame.
test::Picture& plain_square(test::Picture& picture) {
  test::PlaneMap map(corners);
  picture.draw([&](double x, double y) {
    const Point uv = map(x, y);
    return uv.x > 0 && uv.y > 0 && uv.x < 1 && uv.y < 1 ? 40.0 : 200.0;
  });
  return picture;
}

TEST(MarkerReader, EveryMarkerMayBeOne) {
  for (const char* name : {"DICT_4X4_50", "tag16h5", "tag36h11", "DICT_ARUCO_ORIGINAL", "tagStandard41h12"}) {
    const std::vector<Dictionary> dictionaries = list_of(builtin_dictionary(name));
    const Dictionary& dictionary = dictionaries[0];
    const MarkerReader reader(dictionaries, {});
    const bool reversed = dictionary.border == Border::reversed;
    for (std::size_t id = 0; id < 30; ++id) {
      test::Picture picture(100, 100, reversed ? 30 : 220);
      test::draw_at(picture, dictionary, id, corners);
      EXPECT_TRUE(reader.may_be_marker(picture.frame(), quad_at(corners, reversed))) << name << ' ' << id;
    }
  }
}

TEST(MarkerReader, APlainSquareIsNone) {
  test::Picture picture(100, 100, 200);
  const std::vector<Dictionary> dictionaries = list_of(builtin_dictionary("tag36h11"));
  const MarkerReader reader(dictionaries, {});
  EXPECT_FALSE(reader.may_be_marker(plain_square(picture).frame(), quad_at(corners)));
}

TEST(MarkerReader, APlainSquareIsOneWhenADictionarySaysSo) {
  test::Picture picture(100, 100, 200);
  const std::vector<Dictionary> dictionaries =
      list_of(parse_codes("4 0\nsymmetric 0\n0000\n00ff\n", "plain"));
  const MarkerReader reader(dictionaries, {});
  ASSERT_TRUE(reader.may_be_marker(plain_square(picture).frame(), quad_at(corners)));
  const auto marker = reader.read(picture.frame(), quad_at(corners));
  ASSERT_TRUE(marker);
  EXPECT_EQ(marker->id, 0);
}

TEST(MarkerReader, ReadsAgainWhatChanceHardlyEverMakes) {
  for (const auto& [name, taken] :
       {std::pair("tag36h11", true), {"DICT_6X6_250", true}, {"DICT_4X4_50", false}}) {
    const std::vector<Dictionary> dictionaries = list_of(builtin_dictionary(name));
    test::Picture picture(100, 100, 220);
    test::draw_at(picture, dictionaries[0], 7, corners);
    const MarkerReader reader(dictionaries, {});
    ASSERT_TRUE(reader.read(picture.frame(), quad_at(corners))) << name;
    EXPECT_EQ(reader.read_again(picture.frame(), quad_at(corners)).has_value(), taken) << name;
  }
}

TEST(MarkerReader, WrongBitsOfTinyCellsAreCorrectedWhereChanceIsLow) {
  const auto is_read = [](const char* name, double side) {
    const std::vector<Dictionary> dictionaries = list_of(builtin_dictionary(name));
    Dictionary wrong = dictionaries[0];
    for (std::uint64_t& code : wrong.codes) code ^= 1;
    const auto at = test::turned_square({50.3, 49.8}, side, 12);
    test::Picture picture(100, 100, 220);
    test::draw_at(picture, wrong, 7, at);
    const auto marker = MarkerReader(dictionaries, {}).read(picture.frame(), quad_at(at));
    return marker && marker->id == 7 && marker->hamming == 1;
  };
  EXPECT_TRUE(is_read("tag36h11", 11.5));
  EXPECT_TRUE(is_read("tag36h10", 14));
  EXPECT_FALSE(is_read("tag36h10", 11.5)) << "four times as many codes";
}

}  // namespace
}  // namespace runmark
