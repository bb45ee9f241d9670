// Every code of every dictionary OpenCV knows, and of the MIP ones, read back by OpenCV's own detector.

#include <gtest/gtest.h>

#include <map>
#include <opencv2/aruco.hpp>
#include <string>

#include "sheet.h"

namespace runmark {
namespace {

namespace aruco = cv::aruco;

const std::map<std::string, int> predefined{
    {"DICT_4X4_50", aruco::DICT_4X4_50},
    {"DICT_4X4_100", aruco::DICT_4X4_100},
    {"DICT_4X4_250", aruco::DICT_4X4_250},
    {"DICT_4X4_1000", aruco::DICT_4X4_1000},
    {"DICT_5X5_50", aruco::DICT_5X5_50},
    {"DICT_5X5_100", aruco::DICT_5X5_100},
    {"DICT_5X5_250", aruco::DICT_5X5_250},
    {"DICT_5X5_1000", aruco::DICT_5X5_1000},
    {"DICT_6X6_50", aruco::DICT_6X6_50},
    {"DICT_6X6_100", aruco::DICT_6X6_100},
    {"DICT_6X6_250", aruco::DICT_6X6_250},
    {"DICT_6X6_1000", aruco::DICT_6X6_1000},
    {"DICT_7X7_50", aruco::DICT_7X7_50},
    {"DICT_7X7_100", aruco::DICT_7X7_100},
    {"DICT_7X7_250", aruco::DICT_7X7_250},
    {"DICT_7X7_1000", aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", aruco::DICT_ARUCO_ORIGINAL},
    {"DICT_APRILTAG_16h5", aruco::DICT_APRILTAG_16h5},
    {"DICT_APRILTAG_25h9", aruco::DICT_APRILTAG_25h9},
    {"DICT_APRILTAG_36h10", aruco::DICT_APRILTAG_36h10},
    {"DICT_APRILTAG_36h11", aruco::DICT_APRILTAG_36h11},
};

/// A dictionary of our own for OpenCV: checks the order of the cells, not that the codes are the right ones.
cv::Ptr<aruco::Dictionary> custom(const Dictionary& dictionary) {
  const int side = dictionary.width - 2;
  auto made = cv::makePtr<aruco::Dictionary>();
  made->markerSize = side;
  made->maxCorrectionBits = 0;
  for (const std::uint64_t code : dictionary.codes) {
    cv::Mat_<std::uint8_t> bits(side, side);
    int left = side * side;
    for (std::uint8_t& bit : bits) bit = static_cast<std::uint8_t>(code >> --left & 1U);
    made->bytesList.push_back(aruco::Dictionary::getByteListFromBits(bits));
  }
  return made;
}

std::vector<Reading> read(const Sheet& sheet, const cv::Ptr<aruco::Dictionary>& dictionary, bool turned) {
  const auto parameters = aruco::DetectorParameters::create();
  parameters->errorCorrectionRate = 0;
  parameters->maxErroneousBitsInBorderRate = 0;
  const cv::Mat_<std::uint8_t> picture(sheet.side, sheet.side, const_cast<std::uint8_t*>(sheet.grey.data()));
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
  aruco::detectMarkers(picture, dictionary, corners, ids, parameters);
  std::vector<Reading> readings;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Reading& reading = readings.emplace_back();
    reading.id = ids[i];
    for (std::size_t c = 0; c < 4; ++c) {
      const cv::Point2f p = corners[i][(c + (turned ? 2 : 0)) % 4];
      reading.corners[c] = {p.x, p.y};
    }
  }
  return readings;
}

class EveryCodeOpenCv : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryCodeOpenCv, IsRead) {
  const auto dictionary = builtin_dictionary(GetParam());
  ASSERT_TRUE(dictionary) << dictionary.error();
  const auto known = predefined.find(dictionary->name);
  const bool turned = dictionary->name.starts_with("DICT_APRILTAG");  // OpenCV 4 turns them by 180 degrees
  const cv::Ptr<aruco::Dictionary> peer =
      known == predefined.end() ? custom(*dictionary) : aruco::getPredefinedDictionary(known->second);
  ASSERT_EQ(peer->bytesList.rows, static_cast<int>(dictionary->codes.size()));
  for (std::size_t first = 0; first < dictionary->codes.size();) {
    const Sheet sheet = draw_sheet(*dictionary, first, 6, 1);
    EXPECT_EQ(mistakes(sheet, read(sheet, peer, turned), *dictionary, 2), std::vector<std::string>{});
    first += sheet.markers.size();
    if (one_sheet_only) break;
  }
}

// So that the test above can fail: without the half turn every corner is wrong, and so is an id if one code
// differs by one bit.
TEST(EveryCodeTest, NoticesWrongOrientationAndWrongBits) {
  const auto dictionary = builtin_dictionary("DICT_APRILTAG_36h11");
  ASSERT_TRUE(dictionary);
  const auto peer = aruco::getPredefinedDictionary(aruco::DICT_APRILTAG_36h11);
  const Sheet sheet = draw_sheet(*dictionary, 0, 6, 1);
  EXPECT_EQ(mistakes(sheet, read(sheet, peer, false), *dictionary, 2).size(), sheet.markers.size());
  Dictionary wrong = *dictionary;
  wrong.codes[7] ^= 1U << 20U;
  const Sheet wrong_sheet = draw_sheet(wrong, 0, 6, 1);
  EXPECT_EQ(mistakes(wrong_sheet, read(wrong_sheet, peer, true), wrong, 2).front(),
            "DICT_APRILTAG_36h11 id 7 was read 0 times");
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> list;
  for (const std::string_view name : dictionary_names()) {
    if (!name.starts_with("tag")) list.push_back(name);
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Names, EveryCodeOpenCv, testing::ValuesIn(names()),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace runmark
