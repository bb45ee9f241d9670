#include "render/draw_marker.h"

#include <gtest/gtest.h>

#include <string>

#include "runmark/marker_grid.h"

namespace runmark {
namespace {

/// One character a cell, one line a row: # is black.
std::string picture(const MarkerGrid& grid) {
  std::string text;
  for (int y = grid.first; y < grid.first + grid.side; ++y) {
    for (int x = grid.first; x < grid.first + grid.side; ++x) text += grid.is_white(x, y) ? '.' : '#';
    text += '\n';
  }
  return text;
}

TEST(MarkerGrid, BlackBorder) {
  // OpenCV's marker 0 of DICT_4X4_50.
  EXPECT_EQ(picture(marker_grid(*builtin_dictionary("DICT_4X4_50"), 0)),
            "######\n"
            "#.#..#\n"
            "##.#.#\n"
            "###..#\n"
            "###.##\n"
            "######\n");
}

TEST(MarkerGrid, ReversedBorderWithDataOutside) {
  const auto dictionary =
      parse_codes("3 0\nborder reversed\ncells 1,-2 6,1 3,6 -2,3 1,1 3,1 3,3 1,3\n86\n", "odd");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(picture(marker_grid(*dictionary, 0)),
            ".........\n"
            ".#######.\n"
            ".#.....#.\n"
            ".#.##..##\n"
            ".#.###.#.\n"
            "##.##..#.\n"
            ".#.....#.\n"
            ".#######.\n"
            ".....#...\n");
}

TEST(MarkerGrid, IncludedBorderDrawsWhatTheCodeSays) {
  const auto dictionary = parse_codes("2 0\nborder included\n8\n", "tiny");
  ASSERT_TRUE(dictionary) << dictionary.error();
  const MarkerGrid grid = marker_grid(*dictionary, 0);
  EXPECT_EQ(picture(grid), ".#\n##\n");
  EXPECT_TRUE(grid.is_white(-1, 0));
  EXPECT_TRUE(grid.is_white(0, 2));
}

TEST(DrawMarker, PlacesTheSquareInsideTheMargin) {
  const auto dictionary = builtin_dictionary("DICT_4X4_50");
  const MarkerDrawing drawing = draw_marker(*dictionary, 0, 3, 2);
  EXPECT_EQ(drawing.side, (6 + 2 * 2) * 3);
  EXPECT_EQ(drawing.origin, 6);
  EXPECT_EQ(drawing.square, 18);
  const auto at = [&](int x, int y) { return drawing.grey[static_cast<std::size_t>(y * drawing.side + x)]; };
  EXPECT_EQ(at(5, 5), 255);
  EXPECT_EQ(at(6, 6), 0);
  EXPECT_EQ(at(23, 23), 0);
  EXPECT_EQ(at(24, 23), 255);
  EXPECT_EQ(at(9, 9), 255);  // the first data cell begins here
  EXPECT_EQ(at(8, 9), 0);
  EXPECT_EQ(at(11, 11), 255);
  EXPECT_EQ(at(12, 11), 0);
}

TEST(DrawMarker, CountsCellsOutsideTheSquare) {
  const MarkerDrawing drawing = draw_marker(*builtin_dictionary("tagStandard41h12"), 7, 2, 1);
  EXPECT_EQ(drawing.square, 5 * 2);
  EXPECT_EQ(drawing.origin, (1 + 2) * 2);
  EXPECT_EQ(drawing.side, (5 + 2 * 2 + 2 * 1) * 2);
}

}  // namespace
}  // namespace runmark
