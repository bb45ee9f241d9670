#include "contour/contour_linker.h"

#include <gtest/gtest.h>

#include <string_view>
#include <utility>
#include <vector>

#include "preprocess/crack_runs.h"

namespace runmark {
namespace {

using Polygon = std::vector<std::pair<int, int>>;

struct Found {
  Polygon corners;
  bool hole = false;
};

/// Contours of a picture drawn with '#' for dark, one string a row, with a white border added below.
std::vector<Found> contours_of(const std::vector<std::string_view>& picture, Connectivity connectivity,
                               ChainLimits limits = {}, std::size_t capacity = 1000) {
  const int width = static_cast<int>(picture.front().size());
  std::vector<Record> records(capacity);
  std::vector<ChainEnd> ends(max_chain_ends(width));
  std::vector<EndIndex> end_at(static_cast<std::size_t>(width) + 1);
  std::vector<CrackRun> runs(max_crack_runs(width));
  ContourLinker linker(records, ends, end_at, limits);
  std::vector<BitWord> above(bit_words(width));
  std::vector<BitWord> current(bit_words(width));
  std::vector<Found> found;
  for (std::size_t y = 0; y <= picture.size(); ++y) {
    for (int x = 0; x < width; ++x) {
      set_bit(current.data(), x, y < picture.size() && picture[y][static_cast<std::size_t>(x)] == '#');
    }
    const std::size_t count = find_crack_runs(above.data(), current.data(), width, connectivity, runs);
    linker.row(static_cast<std::uint16_t>(y), std::span(runs).first(count), [&](const ClosedChain& chain) {
      Found one{{}, chain.hole};
      chain.runs([&](int from, int to, int line) {
        one.corners.emplace_back(from, line);
        one.corners.emplace_back(to, line);
      });
      found.push_back(one);
    });
    std::swap(above, current);
  }
  EXPECT_EQ(linker.open_ends(), 0U);
  EXPECT_EQ(linker.pool().alive(), 0U);
  return found;
}

TEST(ContourLinker, SquareIsFollowedClockwise) {
  const auto found = contours_of({"....", ".##.", ".##."}, Connectivity::eight);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].hole);
  EXPECT_EQ(found[0].corners, (Polygon{{1, 1}, {3, 1}, {3, 3}, {1, 3}}));
}

TEST(ContourLinker, HoleIsFollowedWithDarkOnTheRight) {
  const auto found = contours_of({"###", "#.#", "###"}, Connectivity::eight);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].hole) << "the hole closes first";
  EXPECT_EQ(found[0].corners, (Polygon{{2, 1}, {1, 1}, {1, 2}, {2, 2}}));
}

TEST(ContourLinker, DiagonalDecidesTheConnectivity) {
  const std::vector<std::string_view> picture{"#.", ".#"};
  EXPECT_EQ(contours_of(picture, Connectivity::eight).size(), 1U);
  EXPECT_EQ(contours_of(picture, Connectivity::four).size(), 2U);
  const std::vector<std::string_view> mirrored{".#", "#."};
  EXPECT_EQ(contours_of(mirrored, Connectivity::eight).size(), 1U);
  EXPECT_EQ(contours_of(mirrored, Connectivity::four).size(), 2U);
}

TEST(ContourLinker, CombBreaksTheTurnLimit) {
  const std::vector<std::string_view> comb{"#.#.#.#.#", "#########"};
  EXPECT_EQ(contours_of(comb, Connectivity::eight).size(), 1U);
  EXPECT_EQ(contours_of(comb, Connectivity::eight, {.max_turns = 9}).size(), 0U);
  EXPECT_EQ(contours_of(comb, Connectivity::eight, {.max_turns = 10}).size(), 1U);
}

TEST(ContourLinker, FullPoolDropsChainsAndStaysWhole) {
  const std::vector<std::string_view> picture{"#.#.#", "#.#.#", ".....", ".###.", ".###."};
  // The third bar finds no record; the first cannot close and makes room for the second.
  EXPECT_EQ(contours_of(picture, Connectivity::eight, {}, 2).size(), 2U);
  EXPECT_EQ(contours_of(picture, Connectivity::eight, {}, 6).size(), 4U);
}

}  // namespace
}  // namespace runmark
