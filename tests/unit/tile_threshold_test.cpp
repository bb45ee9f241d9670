#include "threshold/tile_threshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace runmark {
namespace {

using Grey = std::vector<std::uint8_t>;

int mean_of_two(int a, int b) { return (a + b + 1) / 2; }

/// Means of means over a tile; pixels beyond the frame are those at its rim.
int tile_mean(const Grey& grey, int width, int height, int tile_x, int tile_y) {
  const auto column = [&](int i) {
    const auto at = [&](int j) {
      const int x = std::min(tile_x * tile_side + i, width - 1);
      const int y = std::min(tile_y * tile_side + j, height - 1);
      return int{grey[static_cast<std::size_t>(y * width + x)]};
    };
    return mean_of_two(mean_of_two(at(0), at(1)), mean_of_two(at(2), at(3)));
  };
  return mean_of_two(mean_of_two(column(0), column(1)), mean_of_two(column(2), column(3)));
}

/// The definition, pixel by pixel over the whole frame, by the 3x3 tiles round the pixel's own.
bool dark_by_definition(const Grey& grey, int width, int height, int x, int y, const TileRule& rule) {
  const int tile_x = x / tile_side;
  const int tile_y = y / tile_side;
  int low = 255;
  int high = 0;
  for (int v = std::max(0, (tile_y - 1) * tile_side); v < std::min(height, (tile_y + 2) * tile_side); ++v) {
    for (int u = std::max(0, (tile_x - 1) * tile_side); u < std::min(width, (tile_x + 2) * tile_side); ++u) {
      const int value = grey[static_cast<std::size_t>(v * width + u)];
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  const auto row_mean = [&](int v) {
    v = std::clamp(v, 0, (height - 1) / tile_side);
    const auto at = [&](int u) {
      return tile_mean(grey, width, height, std::clamp(u, 0, (width - 1) / tile_side), v);
    };
    return mean_of_two(mean_of_two(at(tile_x - 1), at(tile_x + 1)), at(tile_x));
  };
  const int mean = mean_of_two(mean_of_two(row_mean(tile_y - 1), row_mean(tile_y + 1)), row_mean(tile_y));
  const int range = high - low;
  const int below = std::max(low + range / 2 - mean, 0);
  const int rise = range * rule.share / 16;
  const int level = low + rise - std::min({below - below / 4, range / 4 - range / 16, rise});
  // White is twice as light as black where they differ by as much as black has.
  const int dim_limit = 2 * low <= high ? rule.dim_contrast : rule.contrast;
  return range >= std::min(rule.contrast, dim_limit) && grey[static_cast<std::size_t>(y * width + x)] < level;
}

std::vector<bool> threshold_by_bands(const Grey& grey, int width, int height, const TileRule& rule) {
  TileThreshold threshold(width);
  threshold.begin_frame(width, rule);
  std::vector<bool> dark;
  TileBand waiting{};
  const auto emit = [&](int first) {
    std::vector<BitWord> bits(bit_words(width));
    for (int i = 0; i < tile_side && first + i < height; ++i) {
      threshold_row(waiting[static_cast<std::size_t>(i)], width, threshold.levels(), bits.data());
      for (int x = 0; x < width; ++x) dark.push_back(bit_at(bits.data(), x));
    }
  };
  for (int y = 0; y < height; y += tile_side) {
    TileBand band{};
    for (int i = 0; i < tile_side; ++i) {
      band[static_cast<std::size_t>(i)] = grey.data() + std::min(y + i, height - 1) * width;
    }
    threshold.add_band(band);
    if (y > 0) emit(y - tile_side);
    waiting = band;
  }
  threshold.finish();
  emit((height - 1) / tile_side * tile_side);
  return dark;
}

TEST(TileThreshold, FollowsItsDefinitionAtEverySize) {
  std::mt19937 random(7);
  for (const int width : {1, 3, 4, 5, 16, 63, 64, 65, 130}) {
    for (const int height : {1, 2, 4, 5, 9, 12, 17}) {
      // Too few tiles for a noise estimate: the contrast limit is the given one.
      Grey grey(static_cast<std::size_t>(width * height));
      for (auto& g : grey) g = static_cast<std::uint8_t>(random() % 64);
      const TileRule rule{40, 3 + (width + height) % 11, 12};
      const std::vector<bool> dark = threshold_by_bands(grey, width, height, rule);
      ASSERT_EQ(dark.size(), grey.size());
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          ASSERT_EQ(dark[static_cast<std::size_t>(y * width + x)],
                    dark_by_definition(grey, width, height, x, y, rule))
              << width << "x" << height << " at " << x << "," << y;
        }
      }
    }
  }
}

TEST(TileThreshold, FlatIsWhiteAndEdgesFollowTheLight) {
  const int width = 64;
  const int height = 16;
  Grey grey(static_cast<std::size_t>(width * height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Light falls from 40 to 230; a dark bar of 60 % reflectance stands at x 30 to 33.
      const int light = 40 + 3 * x;
      grey[static_cast<std::size_t>(y * width + x)] =
          static_cast<std::uint8_t>(x >= 30 && x < 34 ? light * 6 / 10 : light);
    }
  }
  const std::vector<bool> dark = threshold_by_bands(grey, width, height, {36, 8, 36});
  for (int x = 0; x < width; ++x) EXPECT_EQ(dark[static_cast<std::size_t>(x)], x >= 30 && x < 34) << x;
}

TEST(TileThreshold, TakesLessContrastInTheDark) {
  constexpr int width = 24;
  constexpr int height = 24;
  const auto darkened = [&](int black, int white, int dim_contrast) {
    Grey grey(static_cast<std::size_t>(width * height), static_cast<std::uint8_t>(white));
    for (int y = 0; y < height; ++y) {
      for (int x = 10; x < 13; ++x) {
        grey[static_cast<std::size_t>(y * width + x)] = static_cast<std::uint8_t>(black);
      }
    }
    const std::vector<bool> dark = threshold_by_bands(grey, width, height, {20, 8, dim_contrast});
    return std::count(dark.begin(), dark.end(), true);
  };
  constexpr int bar = 3 * height;
  EXPECT_EQ(darkened(100, 120, 8), bar);
  EXPECT_EQ(darkened(100, 119, 8), 0) << "paper is lighter, beside ink";
  EXPECT_EQ(darkened(14, 28, 8), bar) << "twice as light";
  EXPECT_EQ(darkened(14, 27, 8), 0) << "not quite";
  EXPECT_EQ(darkened(2, 10, 8), bar);
  EXPECT_EQ(darkened(2, 9, 8), 0) << "too little even there";
  EXPECT_EQ(darkened(2, 21, 20), 0);
}

TEST(TileThreshold, KeepsThinWhiteLinesBetweenDarkShapes) {
  const int width = 48;
  const int height = 48;
  // A line a pixel wide that has half of the contrast to the white on the right.
  Grey grey(static_cast<std::size_t>(width * height), 40);
  for (int y = 0; y < height; ++y) {
    grey[static_cast<std::size_t>(y * width + 20)] = 120;
    for (int x = 26; x < 29; ++x) grey[static_cast<std::size_t>(y * width + x)] = 200;
  }
  const std::vector<bool> dark = threshold_by_bands(grey, width, height, {20, 9, 20});
  for (int y = 0; y < height; ++y) {
    EXPECT_FALSE(dark[static_cast<std::size_t>(y * width + 20)]) << y;
    EXPECT_TRUE(dark[static_cast<std::size_t>(y * width + 19)]) << y;
  }
}

TEST(NoiseFloor, FollowsTheNoiseOfRowsSeen) {
  std::mt19937 random(1);
  for (const double sigma : {0.5, 2.0, 5.0}) {
    std::normal_distribution<double> noise(128, sigma);
    NoiseFloor floor;
    floor.begin_frame();
    EXPECT_EQ(floor.contrast(), 0) << "nothing seen yet";
    for (int band = 0; band < 40; ++band) {
      std::vector<std::uint8_t> low(160, 255);
      std::vector<std::uint8_t> high(160, 0);
      for (std::size_t tile = 0; tile < low.size(); ++tile) {
        for (int i = 0; i < 9 * tile_side * tile_side; ++i) {
          const auto value = static_cast<std::uint8_t>(std::clamp(std::lround(noise(random)), 0L, 255L));
          low[tile] = std::min(low[tile], value);
          high[tile] = std::max(high[tile], value);
        }
      }
      TileLight tiles(160);
      tiles.lowest = low;
      tiles.highest = high;
      floor.add({&tiles, &tiles, &tiles}, 160);
    }
    const int limit = floor.contrast();
    EXPECT_GT(limit, 5.5 * sigma) << "above the usual range of nine tiles of noise";
    EXPECT_LT(limit, 8 * sigma + 3);
  }
}

}  // namespace
}  // namespace runmark
