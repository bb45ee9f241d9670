#include <gtest/gtest.h>

#include <opencv2/aruco/charuco.hpp>

#include "runmark/board.h"

namespace runmark {
namespace {

Dictionary dictionary() { return *builtin_dictionary("DICT_4X4_50"); }

TEST(BoardLayout, CharucoIsThatOfOpenCvSince46) {
  for (const auto& [columns, rows] : {std::pair{5, 7}, {4, 6}, {7, 4}, {6, 5}}) {
    const auto ours =
        charuco_board(dictionary(), {.columns = columns, .rows = rows, .square = 2, .marker = 1.5});
    ASSERT_TRUE(ours) << ours.error();
    const auto theirs = cv::aruco::CharucoBoard::create(
        columns, rows, 2, 1.5, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50));
    ASSERT_EQ(ours->markers.size(), theirs->ids.size());
    for (std::size_t i = 0; i < theirs->ids.size(); ++i) {
      EXPECT_EQ(ours->markers[i].id, theirs->ids[i]);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(ours->markers[i].corners[k].x, theirs->objPoints[i][k].x, 1e-6);
        EXPECT_NEAR(ours->markers[i].corners[k].y, theirs->objPoints[i][k].y, 1e-6);
      }
    }
    ASSERT_EQ(ours->chess_corners.size(), theirs->chessboardCorners.size());
    for (std::size_t i = 0; i < theirs->chessboardCorners.size(); ++i) {
      EXPECT_NEAR(ours->chess_corners[i].x, theirs->chessboardCorners[i].x, 1e-6);
      EXPECT_NEAR(ours->chess_corners[i].y, theirs->chessboardCorners[i].y, 1e-6);
    }
  }
}

TEST(BoardLayout, GridIsThatOfOpenCv) {
  const auto ours =
      grid_board(dictionary(), {.columns = 3, .rows = 4, .marker = 2, .gap = 0.5, .first_id = 7});
  ASSERT_TRUE(ours) << ours.error();
  const auto theirs = cv::aruco::GridBoard::create(
      3, 4, 2, 0.5, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), 7);
  ASSERT_EQ(ours->markers.size(), theirs->ids.size());
  for (std::size_t i = 0; i < theirs->ids.size(); ++i) {
    EXPECT_EQ(ours->markers[i].id, theirs->ids[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(ours->markers[i].corners[k].x, theirs->objPoints[i][k].x, 1e-6);
      EXPECT_NEAR(ours->markers[i].corners[k].y, theirs->objPoints[i][k].y, 1e-6);
    }
  }
}

TEST(BoardLayout, LegacyCharucoDiffersWithEvenRowsOnly) {
  const CharucoLayout odd{.columns = 4, .rows = 5, .square = 1, .marker = 0.5, .legacy = true};
  EXPECT_TRUE(odd.is_black(0, 0));
  CharucoLayout even = odd;
  even.rows = 6;
  EXPECT_FALSE(even.is_black(0, 0));
  EXPECT_TRUE(even.is_black(0, 5));  // the bottom-left square, from which it was counted
  const auto board = charuco_board(dictionary(), even);
  ASSERT_TRUE(board);
  EXPECT_EQ(board->markers[0].id, 0);
  EXPECT_NEAR(board->markers[0].corners[0].x, 0.25, 1e-12);
  EXPECT_NEAR(board->markers[0].corners[0].y, 0.25, 1e-12);
}

TEST(BoardLayout, TellsWhatIsWrong) {
  const auto error = [](const CharucoLayout& layout) { return charuco_board(dictionary(), layout).error(); };
  EXPECT_NE(error({.columns = 1, .rows = 5, .square = 1, .marker = 0.5}).find("not 1 x 5"),
            std::string::npos);
  EXPECT_NE(error({.columns = 4, .rows = 5, .square = 1, .marker = 1}).find("less than that of the squares"),
            std::string::npos);
  EXPECT_NE(error({.columns = 20, .rows = 20, .square = 1, .marker = 0.5}).find("DICT_4X4_50 has 50"),
            std::string::npos);
  EXPECT_NE(error({.columns = 4, .rows = 5, .square = 1, .marker = 0.5, .first_id = 45}).find("45 to 54"),
            std::string::npos);
  EXPECT_NE(
      grid_board(dictionary(), {.columns = 2, .rows = 2, .marker = 0, .gap = 1}).error().find("positive"),
      std::string::npos);
  EXPECT_NE(
      grid_board(dictionary(), {.columns = 2, .rows = 2, .marker = 1, .first_id = -1}).error().find("-1"),
      std::string::npos);
}

}  // namespace
}  // namespace runmark
