// ChArUco corners beside OpenCV's on the same renders, and on real frames.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgcodecs.hpp>

#include "boards/plane_map.h"
#include "render/rng.h"
#include "runmark/board_view.h"
#include "runmark/detector.h"
#include "support/board_scene.h"

namespace runmark {
namespace {

// OpenCV's corners by index; those not found are missing. It gives ChArUco corners half a pixel to the right
// and below of where its own marker corners would be (cornerSubPix is called with 0.5 taken off, which is
// added again).
std::vector<std::pair<int, Point>> corners_by_opencv(const cv::Mat& grey, const CharucoLayout& layout,
                                                     int dictionary) {
  const auto known = cv::aruco::getPredefinedDictionary(dictionary);
  const auto board =
      cv::aruco::CharucoBoard::create(layout.columns, layout.rows, static_cast<float>(layout.square),
                                      static_cast<float>(layout.marker), known);
  std::vector<std::vector<cv::Point2f>> markers;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, known, markers, ids);
  std::vector<std::pair<int, Point>> corners;
  if (ids.empty()) return corners;
  std::vector<cv::Point2f> places;
  std::vector<int> indices;
  cv::aruco::interpolateCornersCharuco(markers, ids, grey, board, places, indices);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    corners.push_back(
        {indices[i], {static_cast<double>(places[i].x) - 0.5, static_cast<double>(places[i].y) - 0.5}});
  }
  return corners;
}

struct Tally {
  double square_sum = 0;
  int count = 0;
  void add(double off) {
    square_sum += off * off;
    ++count;
  }
  [[nodiscard]] double rms() const { return std::sqrt(square_sum / count); }
};

TEST(CharucoCorners, MoreThanOpenCvFindsAndCloserToTheTruth) {
  const Dictionary dictionary = *builtin_dictionary("DICT_5X5_100");
  auto detector = *Detector::create({.max_width = 960, .max_height = 720}, {dictionary});
  render::Rng rng(7);
  Tally ours;
  Tally shared_ours;
  Tally shared_theirs;
  int theirs_found = 0;
  for (int i = 0; i < 25; ++i) {
    CharucoLayout layout{.columns = 5 + rng.below(5), .rows = 4 + rng.below(5), .square = 1};
    layout.marker = rng.uniform(0.6, 0.8);
    const Board board = *charuco_board(dictionary, layout);
    test::BoardScene made = test::board_scene(
        board, dictionary,
        {rng.uniform(200, 500), rng.uniform(0, 1), rng.uniform(0, 6.28), rng.uniform(0, 6.28)});
    made.scene.optics.blur = rng.uniform(0.3, 1.8);
    made.scene.sensor.noise = rng.uniform(0.5, 5);
    made.scene.sensor.gamma = rng.chance(0.3) ? 2.2 : 1;
    made.scene.sensor.seed = rng.next();
    render::RenderedFrame frame = render::render(made.scene);
    const ImageView view = test::view_of(frame);
    const BoardView seen = view_board(board, detector.detect(view).markers, view);
    const cv::Mat grey(frame.height, frame.width, CV_8U, frame.grey.data());
    const auto theirs = corners_by_opencv(grey, layout, cv::aruco::DICT_5X5_100);
    theirs_found += static_cast<int>(theirs.size());
    const auto off = [&](int index, Point place) {
      const Point3& p = board.chess_corners[static_cast<std::size_t>(index)];
      const Point exact = made.scene.camera.picture(made.plane, p.x, p.y);
      return std::hypot(place.x - exact.x, place.y - exact.y);
    };
    for (const SeenCorner& corner : seen.corners) {
      ours.add(off(corner.index, corner.place));
      for (const auto& [index, place] : theirs) {
        if (index != corner.index) continue;
        shared_ours.add(off(index, corner.place));
        shared_theirs.add(off(index, place));
      }
    }
  }
  std::printf("ours %d corners, %.4f px rms; shared %d: ours %.4f, OpenCV's %.4f; OpenCV found %d\n",
              ours.count, ours.rms(), shared_ours.count, shared_ours.rms(), shared_theirs.rms(),
              theirs_found);
  EXPECT_GE(ours.count, theirs_found);
  EXPECT_LT(ours.rms(), 0.1);
  EXPECT_LT(shared_ours.rms(), 0.5 * shared_theirs.rms());
}

// rms distance from where the best homography has them.
double bend_of(const std::vector<Point>& board, const std::vector<Point>& picture) {
  const std::optional<PlaneMap> map = PlaneMap::fit(board, picture);
  Tally off;
  for (std::size_t i = 0; i < board.size(); ++i) {
    const Point p = (*map)(board[i]);
    off.add(std::hypot(p.x - picture[i].x, p.y - picture[i].y));
  }
  return off.rms();
}

struct RealBoard {
  const char* image;
  const char* dictionary;
  int opencv;
  int columns;
  int rows;
  double marker;  // share of a square
  bool inverted;
  std::size_t corners;  // that are to be found at least
};

TEST(CharucoCorners, AtLeastOpenCvsOnRealFrames) {
  const char* shared = std::getenv("RUNMARK_SHARED");
  const std::filesystem::path folder =
      std::filesystem::path(shared != nullptr ? shared : RUNMARK_SOURCE_DIR "/../shared") /
      "real-images/images";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there: no real frames are read";
  for (const RealBoard& real : {
           RealBoard{"caliscope__cal_in_c0_001.jpg", "DICT_4X4_50", cv::aruco::DICT_4X4_50, 4, 5, 0.75, true,
                     12},
           {"caliscope__cal_in_c2_005.jpg", "DICT_4X4_50", cv::aruco::DICT_4X4_50, 4, 5, 0.75, true, 11},
           {"caliscope__cal_po_c3_003.jpg", "DICT_4X4_50", cv::aruco::DICT_4X4_50, 4, 5, 0.75, true, 12},
           {"industrial_c__2.jpg", "DICT_6X6_50", cv::aruco::DICT_6X6_50, 5, 7, 0.5, false, 24},
           {"industrial_c__12.jpg", "DICT_6X6_50", cv::aruco::DICT_6X6_50, 5, 7, 0.5, false, 24},
           {"opencv_contr__chocclusion_original.jpg", "DICT_6X6_250", cv::aruco::DICT_6X6_250, 5, 7, 0.5,
            false, 18},
           {"allwpilib__wpical_cal_009.jpg", "DICT_5X5_50", cv::aruco::DICT_5X5_50, 12, 8, 0.75, false, 77},
       }) {
    const cv::Mat grey = cv::imread((folder / real.image).string(), cv::IMREAD_GRAYSCALE);
    ASSERT_FALSE(grey.empty()) << real.image;
    const CharucoLayout layout{
        .columns = real.columns, .rows = real.rows, .square = 1, .marker = real.marker};
    const Dictionary dictionary = *builtin_dictionary(real.dictionary);
    const Board board = *charuco_board(dictionary, layout);
    auto detector = *Detector::create(
        {.max_width = grey.cols, .max_height = grey.rows, .inverted = real.inverted}, {dictionary});
    const auto view =
        ImageView::grey(grey.data, grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step[0]));
    const BoardView seen = view_board(board, detector.detect(view).markers, view);
    const cv::Mat black_on_white = real.inverted ? cv::Mat(255 - grey) : grey;
    const auto theirs = corners_by_opencv(black_on_white, layout, real.opencv);
    EXPECT_EQ(layout_advice(board, detector.markers()), "") << real.image;
    EXPECT_GE(seen.corners.size(), theirs.size()) << real.image;
    EXPECT_GE(seen.corners.size(), real.corners) << real.image;
    // There is no truth, but a board is flat: corners that are right go by one homography, but for the lens.
    std::vector<Point> on_board;
    std::vector<Point> by_us;
    std::vector<Point> by_them;
    for (const SeenCorner& corner : seen.corners) {
      for (const auto& [index, place] : theirs) {
        if (index != corner.index) continue;
        const Point3& p = board.chess_corners[static_cast<std::size_t>(index)];
        on_board.push_back({p.x, p.y});
        by_us.push_back(corner.place);
        by_them.push_back(place);
      }
    }
    if (on_board.size() < 8) continue;
    const double ours = bend_of(on_board, by_us);
    const double others = bend_of(on_board, by_them);
    std::printf("%s: %zu corners, OpenCV %zu; off a plane by %.3f px, OpenCV's by %.3f\n", real.image,
                seen.corners.size(), theirs.size(), ours, others);
    EXPECT_LT(ours, others + 0.02) << real.image;
  }
}

}  // namespace
}  // namespace runmark
