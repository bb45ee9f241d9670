#include "runmark/marker_sizes.h"

#include <gtest/gtest.h>

namespace runmark {
namespace {

Marker marker(const char* dictionary, int id) {
  Marker m;
  m.dictionary = dictionary;
  m.id = id;
  return m;
}

TEST(MarkerSizes, LaterOnesWin) {
  const std::vector<std::string> texts{"0.1", "5=0.2", "10-20=0.3", "tag36h11:=0.4", "tag36h11:5=0.5"};
  const auto sizes = MarkerSizes::parse(texts);
  ASSERT_TRUE(sizes) << sizes.error();
  EXPECT_EQ(sizes->of(marker("DICT_4X4_50", 1)), 0.1);
  EXPECT_EQ(sizes->of(marker("DICT_4X4_50", 5)), 0.2);
  EXPECT_EQ(sizes->of(marker("DICT_4X4_50", 20)), 0.3);
  EXPECT_EQ(sizes->of(marker("tag36h11", 10)), 0.4);
  EXPECT_EQ(sizes->of(marker("tag36h11", 5)), 0.5);
}

TEST(MarkerSizes, UnknownIdsHaveNone) {
  const std::vector<std::string> texts{"5=0.2"};
  EXPECT_EQ(MarkerSizes::parse(texts)->of(marker("tag36h11", 6)), std::nullopt);
}

TEST(MarkerSizes, RefuseWhatMakesNoSense) {
  for (const char* text : {"", "0", "-1", "x", "1=", "=1", "a=1", "5-3=1", "3-=1", "inf", "nan", "1e400"}) {
    const std::vector<std::string> texts{text};
    EXPECT_FALSE(MarkerSizes::parse(texts)) << text;
  }
}

}  // namespace
}  // namespace runmark
