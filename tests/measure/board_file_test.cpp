#include "runmark/board_file.h"

#include <gtest/gtest.h>

namespace runmark {
namespace {

TEST(BoardFile, DescriptionsAndJsonMakeTheSameBoards) {
  const auto described = load_board("charuco:DICT_5X5_100:5x8:0.03:0.02:legacy");
  ASSERT_TRUE(described) << described.error();
  const auto written =
      parse_board(R"({"type": "charuco", "dictionary": "DICT_5X5_100", "columns": 5, "rows": 8,
                                       "square": 0.03, "marker": 0.02, "legacy": true})");
  ASSERT_TRUE(written) << written.error();
  ASSERT_EQ(described->markers.size(), written->markers.size());
  EXPECT_EQ(described->markers[3].corners[2].x, written->markers[3].corners[2].x);
  EXPECT_TRUE(described->charuco->legacy);
  const auto grid = load_board("grid:tag36h11:3x2:0.1:0.02");
  ASSERT_TRUE(grid) << grid.error();
  EXPECT_EQ(grid->markers.size(), 6U);
  EXPECT_NEAR(grid->markers[1].corners[0].x, 0.12, 1e-12);
}

TEST(BoardFile, MarkersMayStandAnywhere) {
  const auto board = parse_board(R"({"dictionary": "tag36h11", "markers": [
      {"id": 0, "size": 0.1, "centre": [0, 0, 0]},
      {"id": 1, "size": 0.1, "centre": [0.2, 0, 0], "rotation": [0, -1.5707963267948966, 0]},
      {"id": 2, "dictionary": "DICT_4X4_50", "corners": [[0, 1, 0], [0.5, 1, 0], [0.5, 1.5, 0], [0, 1.5, 0]]}]})");
  ASSERT_TRUE(board) << board.error();
  ASSERT_EQ(board->markers.size(), 3U);
  EXPECT_NEAR(board->markers[0].corners[0].x, -0.05, 1e-12);
  EXPECT_NEAR(board->markers[1].corners[0].x, 0.2, 1e-12);
  EXPECT_NEAR(board->markers[1].corners[0].z, -0.05, 1e-12);
  EXPECT_NEAR(board->markers[1].corners[1].z, 0.05, 1e-12);
  EXPECT_EQ(board->markers[2].dictionary, "DICT_4X4_50");
}

TEST(BoardFile, TellsWhatIsWrong) {
  const auto json = [](const char* text) { return parse_board(text).error(); };
  EXPECT_NE(json("{").find("no JSON"), std::string::npos);
  EXPECT_NE(json("[]").find("object"), std::string::npos);
  EXPECT_NE(json("{}").find("has no 'type'"), std::string::npos);
  EXPECT_NE(json(R"({"type": "x", "dictionary": "DICT_4X4_50"})").find("'x'"), std::string::npos);
  EXPECT_NE(json(R"({"type": "grid", "dictionary": "nothing"})").find("nothing"), std::string::npos);
  for (const char* rows : {"1e200", "-1e200", "4294967297", "2.5"}) {
    const std::string text =
        std::string(R"({"type": "grid", "dictionary": "tag36h11", "columns": 3, "rows": )") + rows +
        R"(, "marker": 1, "gap": 1})";
    EXPECT_NE(json(text.c_str()).find("'rows' is no whole number or too large"), std::string::npos) << rows;
  }
  EXPECT_NE(json(R"({"markers": []})").find("not a list of markers"), std::string::npos);
  EXPECT_NE(json(R"({"markers": [{"id": "a"}]})").find("marker 0 of the list: 'id' is of the wrong kind"),
            std::string::npos);
  EXPECT_NE(json(R"({"markers": [{"id": 1, "corners": [[0,0,0],[1,0,0],[0,1,0],[1,1,0]]}]})").find("square"),
            std::string::npos);
  EXPECT_NE(
      json(
          R"({"markers": [{"id": 1, "size": 1, "centre": [0,0,0]}, {"id": 1, "size": 1, "centre": [2,0,0]}]})")
          .find("id 1 is there twice"),
      std::string::npos);
  EXPECT_NE(load_board("charuco:DICT_4X4_50:5:1:2").error().find("COLUMNSxROWS"), std::string::npos);
  EXPECT_NE(load_board("charuco:DICT_4X4_50:5x7:a:2").error().find("'a' is not a length"), std::string::npos);
  EXPECT_NE(load_board("circle").error().find("a board is a .json file"), std::string::npos);
  EXPECT_NE(load_board("/nowhere.json").error().find("cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace runmark
