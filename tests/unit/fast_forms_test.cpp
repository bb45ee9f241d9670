// Every form for a vector extension against the plain form, on random rows of every width that matters and
// on rows like a camera's. Prints how much faster each is here.

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "pipeline/halve.h"
#include "pipeline/halve_fast.h"
#include "preprocess/crack_runs_fast.h"
#include "preprocess/specks_fast.h"
#include "support/vector_targets.h"
#include "threshold/grey_fast.h"
#include "threshold/tiles_fast.h"

namespace runmark {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<BitWord>;

constexpr int widths[] = {1, 2, 3, 7, 15, 16, 17, 31, 33, 63, 64, 65, 127, 128, 129, 160, 333, 640, 1921};

Bytes random_bytes(std::mt19937& random, std::size_t count) {
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// A row like a camera's: slow light, noise and a few edges.
Bytes camera_row(std::mt19937& random, std::size_t count) {
  Bytes bytes(count);
  int level = 120;
  for (std::uint8_t& byte : bytes) {
    if (random() % 40 == 0) level = static_cast<int>(random() % 220) + 10;
    byte = static_cast<std::uint8_t>(level + static_cast<int>(random() % 12));
  }
  return bytes;
}

Words random_bits(std::mt19937& random, int width, unsigned density) {
  Words words(bit_words(width));
  for (int x = 0; x < width; ++x) set_bit(words.data(), x, random() % 16 < density);
  return words;
}

/// Runs each test once for every extension this processor has.
class FastForms : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { test::use_vector_targets(GetParam()); }
  void TearDown() override { test::use_vector_targets(0); }

  template <class Plain, class Fast>
  static void print_speed(const char* what, Plain&& plain, Fast&& fast) {
    const auto time_of = [](auto&& work) {
      using Clock = std::chrono::steady_clock;
      auto least = Clock::duration::max();
      for (int round = 0; round < 20; ++round) {
        const auto begin = Clock::now();
        for (int i = 0; i < 50; ++i) work();
        least = std::min(least, Clock::now() - begin);
      }
      return std::chrono::duration<double, std::micro>(least).count() / 50;
    };
    const double slow = time_of(plain);
    const double quick = time_of(fast);
    std::printf("  %-8s %-16s plain %7.3f us a row, fast %7.3f us, %5.1f times\n",
                hwy::TargetName(GetParam()), what, slow, quick, slow / quick);
  }
};

TEST_P(FastForms, TileLight) {
  std::mt19937 random(1);
  for (const int width : widths) {
    const auto count = static_cast<std::size_t>(width);
    const std::array rows{random_bytes(random, count), random_bytes(random, count), camera_row(random, count),
                          camera_row(random, count)};
    const TileBand band{rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data()};
    TileLight light(static_cast<std::size_t>(tiles_across(width)));
    TileLight fast_light = light;
    tile_light(band, width, light);
    fast::tile_light(band, width, fast_light);
    ASSERT_EQ(fast_light.lowest, light.lowest) << width;
    ASSERT_EQ(fast_light.highest, light.highest) << width;
    ASSERT_EQ(fast_light.mean, light.mean) << width;
    if (width != 1921) continue;
    print_speed(
        "tile_light", [&] { tile_light(band, width, light); },
        [&] { fast::tile_light(band, width, fast_light); });
  }
}

TEST_P(FastForms, TileLevels) {
  std::mt19937 random(2);
  for (const int tiles : widths) {
    const auto count = static_cast<std::size_t>(tiles);
    std::vector<TileLight> light(3, TileLight(count));
    for (TileLight& band : light) {
      band.lowest = random_bytes(random, count);
      band.highest = random_bytes(random, count);
      for (std::size_t i = 0; i < count; ++i) {
        if (band.lowest[i] > band.highest[i]) std::swap(band.lowest[i], band.highest[i]);
        const int range = band.highest[i] - band.lowest[i] + 1;
        band.mean[i] = static_cast<std::uint8_t>(band.lowest[i] + static_cast<int>(random() % 256) % range);
      }
    }
    const ThreeBands bands{&light[0], &light[1], &light[2]};
    for (const TileRule rule :
         {TileRule{20, 8, 8}, TileRule{1, 16, 1}, TileRule{255, 1, 255}, TileRule{200, 9, 1}}) {
      Bytes levels(count);
      Bytes fast_levels(count);
      tile_levels(bands, tiles, rule, levels.data());
      fast::tile_levels(bands, tiles, rule, fast_levels.data());
      ASSERT_EQ(fast_levels, levels) << tiles << " tiles, contrasts " << rule.contrast << ", "
                                     << rule.dim_contrast;
    }
  }
}

TEST_P(FastForms, ThresholdRow) {
  std::mt19937 random(3);
  for (const int width : widths) {
    const Bytes grey = random_bytes(random, static_cast<std::size_t>(width));
    const Bytes levels = random_bytes(random, static_cast<std::size_t>(tiles_across(width)));
    Words bits(bit_words(width), ~BitWord{0});
    Words fast_bits = bits;
    threshold_row(grey.data(), width, levels.data(), bits.data());
    fast::threshold_row(grey.data(), width, levels.data(), fast_bits.data());
    ASSERT_EQ(fast_bits, bits) << width;
    if (width != 1921) continue;
    print_speed(
        "threshold_row", [&] { threshold_row(grey.data(), width, levels.data(), bits.data()); },
        [&] { fast::threshold_row(grey.data(), width, levels.data(), bits.data()); });
  }
}

TEST_P(FastForms, GreyRow) {
  std::mt19937 random(4);
  for (const int width : widths) {
    for (const int step : {1, 2, 3, 4}) {
      // The last pixel's unused bytes are not there to be read.
      for (const PixelFormat format : {PixelFormat::grey, PixelFormat::rgb, PixelFormat::bgr}) {
        const int channels = format == PixelFormat::grey ? 1 : 3;
        if (step < channels) continue;
        const Bytes pixels = random_bytes(random, static_cast<std::size_t>((width - 1) * step + channels));
        Bytes grey(static_cast<std::size_t>(width));
        Bytes fast_grey = grey;
        grey_row(pixels.data(), width, step, format, grey.data());
        fast::grey_row(pixels.data(), width, step, format, fast_grey.data());
        ASSERT_EQ(fast_grey, grey) << width << " pixels, step " << step;
        if (width != 1921 || step != 3 || format != PixelFormat::bgr) continue;
        print_speed(
            "grey_row", [&] { grey_row(pixels.data(), width, step, format, grey.data()); },
            [&] { fast::grey_row(pixels.data(), width, step, format, grey.data()); });
      }
    }
  }
}

TEST_P(FastForms, HalveRows) {
  std::mt19937 random(5);
  for (const int width : widths) {
    const Bytes upper = random_bytes(random, static_cast<std::size_t>(2 * width));
    const Bytes lower = camera_row(random, static_cast<std::size_t>(2 * width));
    Bytes half(static_cast<std::size_t>(width));
    Bytes fast_half = half;
    halve_rows(upper.data(), lower.data(), width, half.data());
    fast::halve_rows(upper.data(), lower.data(), width, fast_half.data());
    ASSERT_EQ(fast_half, half) << width;
    if (width != 1921) continue;
    print_speed(
        "halve_rows", [&] { halve_rows(upper.data(), lower.data(), width, half.data()); },
        [&] { fast::halve_rows(upper.data(), lower.data(), width, half.data()); });
  }
}

TEST_P(FastForms, CrackRuns) {
  std::mt19937 random(6);
  for (const int width : widths) {
    for (const unsigned density : {1U, 3U, 8U, 13U}) {
      const Words above = random_bits(random, width, density);
      const Words current = random_bits(random, width, density);
      std::vector<CrackRun> runs(max_crack_runs(width) + fast::crack_runs_slack);
      std::vector<CrackRun> fast_runs = runs;
      for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
        runs.resize(max_crack_runs(width));
        fast_runs.resize(max_crack_runs(width) + fast::crack_runs_slack);
        runs.resize(find_crack_runs(above.data(), current.data(), width, connectivity, runs));
        fast_runs.resize(fast::find_crack_runs(above.data(), current.data(), width, connectivity, fast_runs));
        ASSERT_EQ(fast_runs, runs) << width << " pixels, density " << density;
      }
      if (width != 1921 || density != 1) continue;
      runs.resize(max_crack_runs(width) + fast::crack_runs_slack);
      const auto four = Connectivity::four;
      print_speed(
          "find_crack_runs",
          [&] { std::ignore = find_crack_runs(above.data(), current.data(), width, four, runs); },
          [&] { std::ignore = fast::find_crack_runs(above.data(), current.data(), width, four, runs); });
    }
  }
}

TEST_P(FastForms, DropSpecks) {
  std::mt19937 random(7);
  for (const int width : widths) {
    for (const unsigned density : {1U, 3U, 8U, 13U, 15U}) {
      const Words above = random_bits(random, width, density);
      const Words current = random_bits(random, width, density);
      const Words below = random_bits(random, width, density);
      Words clean(bit_words(width));
      Words fast_clean = clean;
      const auto drop = [&](auto form, Connectivity connectivity, Words& out) {
        form(above.data(), current.data(), below.data(), width, connectivity, out.data());
      };
      for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
        drop(drop_specks, connectivity, clean);
        drop(fast::drop_specks, connectivity, fast_clean);
        ASSERT_EQ(fast_clean, clean) << width << " pixels, density " << density;
      }
      if (width != 1921 || density != 1) continue;
      print_speed(
          "drop_specks", [&] { drop(drop_specks, Connectivity::four, clean); },
          [&] { drop(fast::drop_specks, Connectivity::four, clean); });
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, FastForms, testing::ValuesIn(test::vector_targets()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace runmark
