#include "threshold/integer_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace runmark {
namespace {

using Grey = std::vector<std::uint8_t>;

struct Range {
  int low = 255;
  int high = 0;
};

/// Extremes of the pixels of tiles [x0, x1) x [y0, y1) that lie in the frame.
Range range_of(const Grey& grey, int width, int height, int x0, int x1, int y0, int y1) {
  Range range;
  for (int y = std::max(0, 4 * y0); y < std::min(height, 4 * y1); ++y) {
    for (int x = std::max(0, 4 * x0); x < std::min(width, 4 * x1); ++x) {
      const int value = grey[static_cast<std::size_t>(y * width + x)];
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  return range;
}

/// The definition, pixel by pixel over the whole frame.
std::vector<bool> by_definition(const Grey& grey, int width, int height, int min_contrast) {
  const int across = (width + 3) / 4;
  const int down = (height + 3) / 4;
  RangeQuartile noise;
  noise.begin_frame();
  int known = 0;  // bands whose ranges the quartile has seen
  std::vector<bool> dark;
  for (int y = 0; y < height; ++y) {
    for (; known < std::min(y / 4 + 2, down); ++known) {
      for (int tile = 0; tile < across; ++tile) {
        const Range r = range_of(grey, width, height, tile, tile + 1, known, known + 1);
        noise.add(r.high - r.low);
      }
    }
    for (int x = 0; x < width; ++x) {
      const Range r = range_of(grey, width, height, x / 4 - 1, x / 4 + 2, y / 4 - 1, y / 4 + 2);
      const bool flat = r.high - r.low < noise.contrast_limit(min_contrast);
      dark.push_back(!flat && grey[static_cast<std::size_t>(y * width + x)] < (r.low + r.high) / 2);
    }
  }
  return dark;
}

std::vector<bool> by_rows(IntegerTiles& tiles, const Grey& grey, int width, int height, int min_contrast) {
  std::vector<bool> dark;
  std::vector<BitWord> bits(bit_words(width));
  const auto take = [&](int rows_in) {
    for (int y = tiles.ready_from(); y < tiles.ready_to(); ++y) {
      EXPECT_EQ(y, static_cast<int>(dark.size()) / width);
      EXPECT_LE(rows_in - y, 8) << "a row must not be needed longer than two bands";
      tiles.threshold(grey.data() + y * width, bits.data());
      for (int x = 0; x < width; ++x) dark.push_back(bit_at(bits.data(), x));
    }
  };
  tiles.begin_frame(width, height, min_contrast);
  for (int y = 0; y < height; ++y) {
    if (tiles.add_row(grey.data() + y * width)) take(y + 1);
  }
  tiles.finish();
  take(height);
  return dark;
}

TEST(IntegerTiles, FollowTheirDefinitionAtEverySize) {
  std::mt19937 random(3);
  IntegerTiles tiles(130);
  for (const int width : {1, 3, 4, 5, 8, 63, 64, 65, 130}) {
    for (const int height : {1, 2, 4, 5, 8, 9, 12, 17, 40}) {
      Grey grey(static_cast<std::size_t>(width * height));
      const auto noise = 1 + random() % 60;
      for (auto& g : grey)
        g = static_cast<std::uint8_t>(100 + random() % noise + (random() % 16 == 0 ? 60 : 0));
      const int contrast = 10 + static_cast<int>(random() % 30);
      EXPECT_EQ(by_rows(tiles, grey, width, height, contrast), by_definition(grey, width, height, contrast))
          << width << "x" << height;
    }
  }
}

TEST(RangeQuartile, SettlesAtTheLowerQuartile) {
  std::mt19937 random(4);
  RangeQuartile quartile;
  quartile.begin_frame();
  EXPECT_EQ(quartile.contrast_limit(20), 20) << "before any tile";
  // A quarter of the ranges lies below 12.
  for (int i = 0; i < 20000; ++i)
    quartile.add(static_cast<int>(random() % 4 == 0 ? random() % 12 : 12 + random() % 80));
  EXPECT_NEAR(quartile.contrast_limit(1), 12 * 9 / 4, 3);
  EXPECT_EQ(quartile.contrast_limit(35), 35) << "never below the minimum";
  for (int i = 0; i < 20000; ++i) quartile.add(200);
  EXPECT_EQ(quartile.contrast_limit(20), 40) << "nor above 40";
  EXPECT_EQ(quartile.contrast_limit(60), 60) << "unless that was asked for";
  for (int i = 0; i < 20000; ++i) quartile.add(0);
  EXPECT_EQ(quartile.contrast_limit(1), 1);
  quartile.begin_frame();
  EXPECT_EQ(quartile.contrast_limit(1), 1);
}

}  // namespace
}  // namespace runmark
