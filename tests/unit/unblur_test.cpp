#include "pattern/unblur.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace runmark {
namespace {

constexpr int width = 8;

std::vector<Cell> data_cells() {
  std::vector<Cell> cells;
  for (int y = 1; y < width - 1; ++y) {
    for (int x = 1; x < width - 1; ++x)
      cells.push_back({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y)});
  }
  return cells;
}

/// The marker's cells with white round it, blurred by that share to each side, with noise.
CellValues blurred(std::uint64_t code, float share, double noise, std::mt19937& random) {
  float sharp[width + 2][width + 2];
  for (auto& row : sharp) {
    for (float& value : row) value = 1;
  }
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) sharp[y + 1][x + 1] = 0;
  }
  std::uint64_t bits = code;
  for (int y = width - 2; y > 0; --y) {
    for (int x = width - 2; x > 0; --x, bits >>= 1) sharp[y + 1][x + 1] = static_cast<float>(bits & 1);
  }
  const float kernel[3] = {share, 1 - 2 * share, share};
  std::normal_distribution<double> grain(0, noise);
  CellValues values;
  values.width = width;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      float sum = 0;
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) sum += kernel[j] * kernel[i] * sharp[y + j][x + i];
      }
      values.at(x, y) = -0.1F + 1.2F * sum + static_cast<float>(grain(random));
    }
  }
  return values;
}

TEST(Unblur, ReadsWhatBlurHasMixed) {
  std::mt19937 random(3);
  int right = 0;
  constexpr int trials = 200;
  for (int i = 0; i < trials; ++i) {
    const std::uint64_t code = (std::uint64_t{random()} << 32 | random()) & 0xFFFFFFFFFU;
    const Unblurred read = unblur(blurred(code, 0.2F, 0.01, random), data_cells(), 0.2F, 0.2F);
    right += read.code == code ? 1 : 0;
  }
  EXPECT_GE(right, trials * 9 / 10);
}

TEST(Unblur, SharpCellsAreClear) {
  std::mt19937 random(4);
  const std::uint64_t code = 0xA53C5A3C5;
  const Unblurred read = unblur(blurred(code, 0, 0, random), data_cells(), 0, 0);
  EXPECT_EQ(read.code, code);
  EXPECT_NEAR(read.margin, 0.5, 1e-3);
}

TEST(Unblur, MakesNothingOfAFlatMarker) {
  CellValues flat;
  flat.width = width;
  for (float& value : flat.values) value = 0.4F;
  EXPECT_EQ(unblur(flat, data_cells(), 0.2F, 0.2F).margin, 0);
}

}  // namespace
}  // namespace runmark
