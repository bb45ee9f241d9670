#include "preprocess/border.h"

#include <gtest/gtest.h>

#include <array>

namespace runmark {
namespace {

TEST(Border, ClearsTheOutermostPixelsOnly) {
  for (const int width : {1, 2, 3, 63, 64, 65, 128}) {
    for (int y = 0; y < 4; ++y) {
      std::array<BitWord, 3> row{};
      for (int x = 0; x < width; ++x) set_bit(row.data(), x, true);
      clear_border(row.data(), width, y, 4);
      for (int x = 0; x < width; ++x) {
        const bool inside = y > 0 && y < 3 && x > 0 && x < width - 1;
        EXPECT_EQ(bit_at(row.data(), x), inside) << width << " " << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace runmark
