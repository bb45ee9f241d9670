#include "runmark/board_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runmark/detector.h"
#include "support/board_scene.h"

namespace runmark {
namespace {

class Eye {
 public:
  explicit Eye(const Dictionary& dictionary, bool inverted = false)
      : detector_(
            *Detector::create({.max_width = 960, .max_height = 720, .inverted = inverted}, {dictionary})) {}
  std::span<const Marker> look(const render::RenderedFrame& frame) {
    return detector_.detect(test::view_of(frame)).markers;
  }

 private:
  Detector detector_;
};

void expect_corners(const BoardView& view, const Board& board, const test::BoardScene& made,
                    double most_rms) {
  double sum = 0;
  for (const SeenCorner& corner : view.corners) {
    const Point3& p = board.chess_corners[static_cast<std::size_t>(corner.index)];
    const Point exact = made.scene.camera.picture(made.plane, p.x, p.y);
    const double off = std::hypot(corner.place.x - exact.x, corner.place.y - exact.y);
    EXPECT_LT(off, 6 * most_rms);
    sum += off * off;
  }
  ASSERT_FALSE(view.corners.empty());
  EXPECT_LT(std::sqrt(sum / static_cast<double>(view.corners.size())), most_rms);
}

void expect_pose(const PoseEstimate& found, const Pose& exact) {
  EXPECT_LT(test::turn_between(found.best.pose, exact), 2e-3);
  EXPECT_LT(test::distance_between(found.best.pose, exact), 2e-3 * exact.translation.z);
  EXPECT_LT(test::mahalanobis2<6>(found.best.covariance, test::difference(found.best.pose, exact)), 25);
}

const CharucoLayout usual{.columns = 6, .rows = 8, .square = 1, .marker = 0.7};

TEST(BoardView, FindsEveryCharucoCornerAndThePose) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  const Board board = *charuco_board(dictionary, usual);
  Eye eye(dictionary);
  for (const double tilt : {0.0, 0.4, 0.8}) {
    for (const double size : {200, 450}) {
      const test::BoardScene made = test::board_scene(board, dictionary, {.size = size, .tilt = tilt});
      const render::RenderedFrame frame = render::render(made.scene);
      const BoardView view = view_board(board, eye.look(frame), test::view_of(frame));
      EXPECT_EQ(view.corners.size(), board.chess_corners.size());
      expect_corners(view, board, made, 0.1);
      const auto found = pose(board, view, test::camera_of(made.scene.camera));
      ASSERT_TRUE(found) << found.error();
      expect_pose(*found, made.pose);
    }
  }
}

TEST(BoardView, WhiteOnBlackBoardIsAsGood) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  const Board board = *charuco_board(dictionary, usual);
  Eye eye(dictionary, true);
  const test::BoardScene made = test::board_scene(board, dictionary, {}, {.inverted = true});
  const render::RenderedFrame frame = render::render(made.scene);
  const BoardView view = view_board(board, eye.look(frame), test::view_of(frame));
  EXPECT_EQ(view.corners.size(), board.chess_corners.size());
  expect_corners(view, board, made, 0.1);
}

TEST(BoardView, ToneCurveMovesNoCorner) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  const Board board = *charuco_board(dictionary, usual);
  Eye eye(dictionary);
  test::BoardScene made = test::board_scene(board, dictionary, {});
  made.scene.sensor.gamma = 2.2;
  const render::RenderedFrame frame = render::render(made.scene);
  const BoardView view = view_board(board, eye.look(frame), test::view_of(frame));
  EXPECT_EQ(view.corners.size(), board.chess_corners.size());
  expect_corners(view, board, made, 0.1);
}

TEST(BoardView, GridGivesItsPoseWithOneWrongMarkerAmongThem) {
  const Dictionary dictionary = *builtin_dictionary("tag36h11");
  const Board board =
      *grid_board(dictionary, {.columns = 4, .rows = 3, .marker = 0.05, .gap = 0.02, .first_id = 10});
  Eye eye(dictionary);
  const test::BoardScene made = test::board_scene(board, dictionary, {.size = 300});
  const render::RenderedFrame frame = render::render(made.scene);
  std::vector<Marker> found;
  for (const Marker& marker : eye.look(frame)) found.push_back(marker);
  ASSERT_EQ(found.size(), 12U);
  // A copy of a marker of the board elsewhere in the picture, and one that is misread as another.
  Marker copy = found[0];
  for (Point& p : copy.corners) p.x += 300;
  found.insert(found.begin(), copy);
  found[5].id = found[6].id;
  const BoardView view = view_board(board, found, test::view_of(frame));
  EXPECT_EQ(view.markers.size(), 11U);
  const auto estimate = pose(board, view, test::camera_of(made.scene.camera));
  ASSERT_TRUE(estimate) << estimate.error();
  expect_pose(*estimate, made.pose);
}

TEST(BoardView, BoardInSpaceHasOneAnswer) {
  // Markers on two sides of a box.
  Board board;
  const auto side = [](int id, Point3 corner, Point3 u, Point3 v) {
    const auto add = [](Point3 a, Point3 b) { return Point3{a.x + b.x, a.y + b.y, a.z + b.z}; };
    return BoardMarker{"", id, {corner, add(corner, u), add(add(corner, u), v), add(corner, v)}};
  };
  board.markers = {side(1, {0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}),
                   side(2, {0.12, 0, 0.02}, {0, 0, 0.1}, {0, 0.1, 0})};
  const Camera camera{640, 480, 500, 500, 320, 240, Lens::plain, {-0.2, 0.05, 0, 0, 0}};
  const Pose exact = pose_from({0.1, 0.6, 0.05}, {-0.05, -0.03, 0.5});
  BoardView view;
  for (int i = 0; i < 2; ++i) {
    SeenMarker seen;
    seen.index = i;
    seen.marker.margin = 0.5F;
    for (std::size_t k = 0; k < 4; ++k) {
      seen.marker.corners[k] = *camera.project(exact(board.markers[static_cast<std::size_t>(i)].corners[k]));
    }
    seen.covariance = corner_covariance(seen.marker);
    view.markers.push_back(seen);
  }
  const auto found = pose(board, view, camera);
  ASSERT_TRUE(found) << found.error();
  EXPECT_FALSE(found->other);
  EXPECT_EQ(found->ambiguity, 0);
  EXPECT_LT(test::turn_between(found->best.pose, exact), 1e-6);
  EXPECT_LT(test::distance_between(found->best.pose, exact), 1e-6);
}

TEST(BoardView, SaysWhenThePictureFitsAnotherLayout) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  Eye eye(dictionary);
  const auto advice = [&](const CharucoLayout& printed, const CharucoLayout& described) {
    const Board board = *charuco_board(dictionary, printed);
    test::BoardScene made = test::board_scene(board, dictionary, {});
    const render::RenderedFrame frame = render::render(made.scene);
    return layout_advice(*charuco_board(dictionary, described), eye.look(frame));
  };
  CharucoLayout legacy = usual;
  legacy.legacy = true;
  CharucoLayout exchanged = usual;
  std::swap(exchanged.columns, exchanged.rows);
  EXPECT_EQ(advice(usual, usual), "");
  EXPECT_EQ(advice(legacy, legacy), "");
  EXPECT_NE(advice(legacy, usual).find("before 4.6"), std::string::npos);
  EXPECT_NE(advice(usual, legacy).find("since 4.6"), std::string::npos);
  EXPECT_NE(advice(usual, exchanged).find("6 x 8 squares"), std::string::npos);
  CharucoLayout small = usual;
  small.marker = 0.55;
  EXPECT_EQ(advice(small, usual),
            "the markers seen are 0.55 of a square wide, not 0.70 as on the board described");
}

TEST(BoardView, SaysWhenMarkersStandOnTheirHeads) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  Eye eye(dictionary);
  const Board board = *charuco_board(dictionary, usual);
  const test::BoardScene made = test::board_scene(board, dictionary, {});
  const render::RenderedFrame frame = render::render(made.scene);
  std::vector<Marker> found;
  for (Marker marker : eye.look(frame)) {
    std::rotate(marker.corners.begin(), marker.corners.begin() + 2, marker.corners.end());
    found.push_back(marker);
  }
  EXPECT_NE(layout_advice(board, found).find("on their heads"), std::string::npos);
}

TEST(BoardView, TellsWhatIsWrong) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  const Board board = *charuco_board(dictionary, usual);
  const Camera camera{640, 480, 500, 500, 320, 240, Lens::plain, {}};
  EXPECT_NE(pose(board, BoardView{}, camera).error().find("too little"), std::string::npos);
  BoardView line;
  for (int i = 0; i < 5; ++i) line.corners.push_back({i, {100.0 + 20 * i, 50}, 0.1});
  EXPECT_NE(pose(board, line, camera).error().find("on one line"), std::string::npos);
  line.corners[0].index = 1000;
  EXPECT_NE(pose(board, line, camera).error().find("not the board's"), std::string::npos);
  EXPECT_NE(pose(board, line, Camera{}).error().find("camera"), std::string::npos);
  EXPECT_TRUE(view_board(board, {}, ImageView{}).corners.empty());
}

}  // namespace
}  // namespace runmark
