#include "preprocess/specks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/contour_scan.h"

namespace runmark {
namespace {

using Picture = std::vector<std::string>;

std::vector<BitWord> row_of(std::string_view text) {
  std::vector<BitWord> row(bit_words(static_cast<int>(text.size())));
  for (std::size_t x = 0; x < text.size(); ++x) set_bit(row.data(), static_cast<int>(x), text[x] == '#');
  return row;
}

/// The middle of three rows, drawn with '#' for dark, without its specks.
std::string cleaned(std::string_view above, std::string_view current, std::string_view below,
                    Connectivity connectivity) {
  const int width = static_cast<int>(current.size());
  std::vector<BitWord> out(bit_words(width));
  drop_specks(row_of(above).data(), row_of(current).data(), row_of(below).data(), width, connectivity,
              out.data());
  std::string text;
  for (int x = 0; x < width; ++x) text += bit_at(out.data(), x) ? '#' : '.';
  return text;
}

TEST(DropSpecks, TakesSinglePixelsOfEitherColour) {
  for (const auto connectivity : {Connectivity::four, Connectivity::eight}) {
    EXPECT_EQ(cleaned(".....###", ".#...#.#", ".....###", connectivity), ".....###");
    EXPECT_EQ(cleaned("........", "#......#", "........", connectivity), "........");
  }
}

TEST(DropSpecks, LeavesWhatIsConnected) {
  for (const auto connectivity : {Connectivity::four, Connectivity::eight}) {
    EXPECT_EQ(cleaned(".#......", ".#.##.#.", "......#.", connectivity), ".#.##.#.");
    EXPECT_EQ(cleaned("########", "#..##.##", "#####.##", connectivity), "#..##.##");
  }
}

TEST(DropSpecks, LooksAtTheCornersOfTheColourThatTheyConnect) {
  EXPECT_EQ(cleaned("#...####", ".#..##.#", "....###.", Connectivity::four), "....##.#");
  EXPECT_EQ(cleaned("#...####", ".#..##.#", "....###.", Connectivity::eight), ".#..####");
}

/// The contours of more than one row, each with its place.
std::vector<std::string> tall_contours(const Picture& picture, Connectivity connectivity, bool drop) {
  const int width = static_cast<int>(picture[0].size());
  const int height = static_cast<int>(picture.size());
  ContourRules rules;
  rules.preprocess.drop_specks = drop;
  rules.preprocess.connectivity = connectivity;
  rules.chains.min_height = 2;
  ContourScan scan(width, rules);
  scan.begin_frame(width, height);
  std::vector<std::string> found;
  for (const std::string& row : picture) {
    std::ranges::copy(row_of(row), scan.next_row());
    scan.advance([&](const ClosedChain& chain) {
      std::string text = chain.hole ? "hole" : "dark";
      chain.runs([&](int from, int to, int y) {
        text += " " + std::to_string(from) + "-" + std::to_string(to) + "," + std::to_string(y);
      });
      found.push_back(text);
    });
  }
  return found;
}

TEST(DropSpecks, ChangesNoContourOfMoreThanOneRow) {
  std::mt19937 random(1);
  std::size_t contours = 0;
  for (int i = 0; i < 300; ++i) {
    const auto density = 1 + random() % 15;
    Picture picture(3 + random() % 20, std::string(3 + random() % 150, '.'));
    for (std::string& row : picture) {
      for (char& pixel : row) pixel = random() % 16 < density ? '#' : '.';
    }
    for (const auto connectivity : {Connectivity::four, Connectivity::eight}) {
      const auto all = tall_contours(picture, connectivity, false);
      ASSERT_EQ(tall_contours(picture, connectivity, true), all);
      contours += all.size();
    }
  }
  EXPECT_GT(contours, 5000U);
}

}  // namespace
}  // namespace runmark
