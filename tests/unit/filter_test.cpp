#include "preprocess/filter.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "preprocess/filter_table.h"

namespace runmark {
namespace {

using Picture = std::vector<std::string>;

/// The picture ('#' dark) after the filter; pixels outside are light.
Picture filtered(const Picture& picture, std::uint8_t cases) {
  const int width = static_cast<int>(picture.front().size());
  const std::size_t words = bit_words(width);
  std::vector<std::vector<BitWord>> rows(picture.size() + 2, std::vector<BitWord>(words));
  for (std::size_t y = 0; y < picture.size(); ++y) {
    for (int x = 0; x < width; ++x) {
      set_bit(rows[y + 1].data(), x, picture[y][static_cast<std::size_t>(x)] == '#');
    }
  }
  Picture result = picture;
  std::vector<BitWord> out(words);
  for (std::size_t y = 0; y < picture.size(); ++y) {
    filter_row(rows[y].data(), rows[y + 1].data(), rows[y + 2].data(), width, cases, out.data());
    for (int x = 0; x < width; ++x) {
      result[y][static_cast<std::size_t>(x)] = bit_at(out.data(), x) ? '#' : '.';
    }
  }
  return result;
}

/// A case changes the picture as it should, and no other case touches it.
void expect_only(FilterCase one, const Picture& picture, const Picture& mended) {
  EXPECT_EQ(filtered(picture, one), mended);
  EXPECT_EQ(filtered(picture, filter_all), mended);
  EXPECT_EQ(filtered(picture, static_cast<std::uint8_t>(filter_all & ~one)), picture);
}

TEST(FilterCaseA, HoleHeldByDiagonalContactsIsFilled) {
  expect_only(filter_hole_with_diagonals, {"..#..", ".#.#.", "..#.."}, {"..#..", ".###.", "..#.."});
  expect_only(filter_hole_with_diagonals, {"..#...", "##.###", "######"}, {"..#...", "######", "######"});
}

TEST(FilterCaseB, SingleObjectPixelsTouchingDiagonallyAreRemoved) {
  expect_only(filter_diagonal_object, {"....", ".#..", "..#.", "...."}, {"....", "....", "....", "...."});
  expect_only(filter_diagonal_object, {"###..", "###..", "...#.", "....."},
              {"###..", "###..", ".....", "....."});
}

TEST(FilterCaseB, RimOfAHoleIsKept) {
  const Picture rim{"##.##", "..#..", "....."};
  EXPECT_EQ(filtered(rim, filter_all), rim);
}

TEST(FilterCaseC, SingleHolePixelsTouchingDiagonallyAreFilled) {
  expect_only(filter_diagonal_hole, {"####", "#.##", "##.#", "####"}, {"####", "####", "####", "####"});
}

TEST(FilterCaseD, LoneObjectPixelIsRemoved) {
  expect_only(filter_lone_object, {"...", ".#.", "..."}, {"...", "...", "..."});
}

TEST(FilterCaseE, LoneHoleIsFilled) {
  expect_only(filter_lone_hole, {"###", "#.#", "###"}, {"###", "###", "###"});
}

TEST(FilterCaseF, EmptyColumnIsFilledWhateverItsLength) {
  expect_only(filter_empty_column, {"###", "#.#", "#.#", "###"}, {"###", "###", "###", "###"});
  const Picture open{"#.#", "#.#", "#.#", "#.#", "#.#", "#.#", "###"};
  EXPECT_EQ(filtered(open, filter_empty_column), (Picture{"#.#", "###", "###", "###", "###", "###", "###"}))
      << "an open end is a notch, which stays";
}

TEST(FilterCaseF, WiderColumnsAndRowsAreKept) {
  const Picture wide{"####", "#..#", "#..#", "####"};
  EXPECT_EQ(filtered(wide, filter_all), wide);
}

TEST(Filter, CheckerboardBecomesSolidInsteadOfTurningOver) {
  EXPECT_EQ(filtered({"#.#.#", ".#.#.", "#.#.#", ".#.#.", "#.#.#"}, filter_all)[2], "#####");
}

TEST(Filter, NothingOnChangesNothing) {
  const Picture picture{"#.#.", ".#..", "###.", "#.#."};
  EXPECT_EQ(filtered(picture, filter_none), picture);
}

// Every window at every place of a row three words long, under every set of cases.
TEST(Filter, FastFormFollowsTheTable) {
  constexpr int width = 130;
  using Row = std::array<BitWord, bit_words(width)>;
  for (int window = 0; window < 512; ++window) {
    for (int x = 0; x < width; ++x) {
      std::array<Row, 3> rows{};
      int visible = 0;  // the window without the pixels outside the row
      for (int bit = 0; bit < 9; ++bit) {
        const int at = x + bit % 3 - 1;
        if (at < 0 || at >= width || (window >> bit & 1) == 0) continue;
        set_bit(rows[static_cast<std::size_t>(bit / 3)].data(), at, true);
        visible |= 1 << bit;
      }
      for (int cases = 0; cases <= filter_all; ++cases) {
        Row fast{};
        filter_row(rows[0].data(), rows[1].data(), rows[2].data(), width, static_cast<std::uint8_t>(cases),
                   fast.data());
        ASSERT_EQ(bit_at(fast.data(), x),
                  filter_pixel(static_cast<Window>(visible), static_cast<std::uint8_t>(cases)))
            << "window " << window << " at " << x << ", cases " << cases;
      }
    }
  }
}

TEST(Filter, FastAndPlainRowsAgreeOnRandomRows) {
  std::mt19937_64 random(20);
  for (int round = 0; round < 4000; ++round) {
    const int width = 1 + static_cast<int>(random() % 600);
    const std::size_t words = bit_words(width);
    const auto density = random() % 101;
    std::array<std::vector<BitWord>, 3> rows;
    for (auto& row : rows) {
      row.assign(words, 0);
      for (int x = 0; x < width; ++x) set_bit(row.data(), x, random() % 100 < density);
    }
    const auto cases = static_cast<std::uint8_t>(random() % (filter_all + 1));
    std::vector<BitWord> fast(words, ~BitWord{0});
    std::vector<BitWord> plain(words, ~BitWord{0});
    filter_row(rows[0].data(), rows[1].data(), rows[2].data(), width, cases, fast.data());
    filter_row_plain(rows[0].data(), rows[1].data(), rows[2].data(), width, cases, plain.data());
    ASSERT_EQ(fast, plain) << "width " << width << ", cases " << int{cases};
  }
}

}  // namespace
}  // namespace runmark
