#include "threshold/fixed_threshold.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

#include "threshold/grey.h"

namespace runmark {
namespace {

TEST(Grey, OneIntegerFormula) {
  EXPECT_EQ(grey_of(0, 0, 0), 0);
  EXPECT_EQ(grey_of(255, 255, 255), 255);
  EXPECT_EQ(grey_of(255, 0, 0), 77);
  EXPECT_EQ(grey_of(0, 255, 0), 149);
  EXPECT_EQ(grey_of(0, 0, 255), 29);
}

TEST(Grey, RowsOfEveryFormat) {
  const std::array<std::uint8_t, 8> bytes{10, 20, 30, 99, 40, 50, 60, 99};
  std::array<std::uint8_t, 2> grey{};
  grey_row(bytes.data(), 2, 4, PixelFormat::rgb, grey.data());
  EXPECT_EQ(grey, (std::array<std::uint8_t, 2>{grey_of(10, 20, 30), grey_of(40, 50, 60)}));
  grey_row(bytes.data(), 2, 4, PixelFormat::bgr, grey.data());
  EXPECT_EQ(grey, (std::array<std::uint8_t, 2>{grey_of(30, 20, 10), grey_of(60, 50, 40)}));
  grey_row(bytes.data(), 2, 4, PixelFormat::grey, grey.data());
  EXPECT_EQ(grey, (std::array<std::uint8_t, 2>{10, 40}));
}

TEST(FixedThreshold, EveryLevelAndPolarity) {
  std::vector<std::uint8_t> grey(256);
  std::iota(grey.begin(), grey.end(), std::uint8_t{0});
  std::vector<BitWord> bits(bit_words(256));
  for (const int level : {0, 1, 128, 255, 256}) {
    for (const bool above : {false, true}) {
      threshold_row(grey.data(), 256, FixedThreshold{level, above}, bits.data());
      for (int x = 0; x < 256; ++x) ASSERT_EQ(bit_at(bits.data(), x), above ? x >= level : x < level);
      EXPECT_EQ(bits.back(), 0U) << "bits beyond the width stay 0";
    }
  }
}

}  // namespace
}  // namespace runmark
