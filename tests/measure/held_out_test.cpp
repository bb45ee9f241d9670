// Calibration on real ChArUco sets beside OpenCV's own pipeline: each frame is left out once, the camera is
// found from the others, and the error is that of the frame left out.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>

#include "pose/refine_pose.h"
#include "runmark/calibration.h"
#include "runmark/detector.h"

namespace runmark {
namespace {

struct RealSet {
  const char* name;
  std::vector<const char*> frames;
  const char* dictionary;
  int opencv;
  int columns;
  int rows;
  double marker;  // share of a square
  bool inverted;
};

// Those of real-images with at least three frames of one camera that show 6 corners or more.
const std::vector<RealSet> sets{
    {"caliscope camera 0",
     {"caliscope__cal_in_c0_001", "caliscope__cal_in_c0_005", "caliscope__cal_po_c0_001",
      "caliscope__cal_po_c0_003"},
     "DICT_4X4_50",
     cv::aruco::DICT_4X4_50,
     4,
     5,
     0.75,
     true},
    {"caliscope camera 2",
     {"caliscope__cal_in_c2_001", "caliscope__cal_in_c2_005", "caliscope__cal_po_c2_001",
      "caliscope__cal_po_c2_003"},
     "DICT_4X4_50",
     cv::aruco::DICT_4X4_50,
     4,
     5,
     0.75,
     true},
    {"industrial",
     {"industrial_c__0", "industrial_c__2", "industrial_c__6", "industrial_c__12"},
     "DICT_6X6_50",
     cv::aruco::DICT_6X6_50,
     5,
     7,
     0.5,
     false},
    {"wpical",
     {"allwpilib__wpical_cal_001", "allwpilib__wpical_cal_005", "allwpilib__wpical_cal_009"},
     "DICT_5X5_50",
     cv::aruco::DICT_5X5_50,
     12,
     8,
     0.75,
     false}};

CalibrationView seen_by_us(const cv::Mat& grey, const RealSet& set, const Board& board,
                           const Dictionary& dictionary) {
  auto detector = *Detector::create(
      {.max_width = grey.cols, .max_height = grey.rows, .inverted = set.inverted}, {dictionary});
  const auto view =
      ImageView::grey(grey.data, grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step[0]));
  return calibration_view(board, view_board(board, detector.detect(view).markers, view), "");
}

CalibrationView seen_by_opencv(const cv::Mat& grey, const RealSet& set, const Board& ours) {
  const cv::Mat picture = set.inverted ? cv::Mat(255 - grey) : grey;
  const auto known = cv::aruco::getPredefinedDictionary(set.opencv);
  const auto board =
      cv::aruco::CharucoBoard::create(set.columns, set.rows, 1, static_cast<float>(set.marker), known);
  std::vector<std::vector<cv::Point2f>> markers;
  std::vector<int> ids;
  cv::aruco::detectMarkers(picture, known, markers, ids);
  CalibrationView view;
  if (ids.empty()) return view;
  std::vector<cv::Point2f> places;
  std::vector<int> indices;
  cv::aruco::interpolateCornersCharuco(markers, ids, picture, board, places, indices);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    view.object.push_back(ours.chess_corners[static_cast<std::size_t>(indices[i])]);
    view.image.push_back({static_cast<double>(places[i].x), static_cast<double>(places[i].y)});
  }
  return view;
}

Camera camera_by_opencv(const std::vector<CalibrationView>& views, cv::Size size) {
  std::vector<std::vector<cv::Point3f>> object;
  std::vector<std::vector<cv::Point2f>> image;
  for (const CalibrationView& view : views) {
    auto& o = object.emplace_back();
    auto& p = image.emplace_back();
    for (const Point3& q : view.object)
      o.emplace_back(static_cast<float>(q.x), static_cast<float>(q.y), 0.0F);
    for (const Point& q : view.image) p.emplace_back(static_cast<float>(q.x), static_cast<float>(q.y));
  }
  cv::Matx33d k;
  cv::Mat d;
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> places;
  cv::calibrateCamera(object, image, size, k, d, turns, places);
  Camera camera{size.width, size.height, k(0, 0), k(1, 1), k(0, 2), k(1, 2), Lens::plain, {}};
  for (std::size_t i = 0; i < 5; ++i) camera.distortion[i] = d.ptr<double>()[i];
  return camera;
}

struct Error2 {
  double sum = 0;
  std::size_t count = 0;
  [[nodiscard]] double rms() const { return std::sqrt(sum / static_cast<double>(count)); }
};

// Of the corners about the pose that fits them best.
void add_error(Error2& error, const CalibrationView& view, const Camera& camera) {
  std::vector<cv::Point3d> object;
  std::vector<cv::Point2d> directions;
  Observation seen;
  for (std::size_t i = 0; i < view.object.size(); ++i) {
    const std::optional<Point> d = camera.direction(view.image[i]);
    ASSERT_TRUE(d);
    object.emplace_back(view.object[i].x, view.object[i].y, 0);
    directions.emplace_back(d->x, d->y);
    seen.add_point(view.object[i], view.image[i], 1);
  }
  cv::Vec3d r;
  cv::Vec3d t;
  ASSERT_TRUE(
      cv::solvePnP(object, directions, cv::Matx33d::eye(), cv::noArray(), r, t, false, cv::SOLVEPNP_IPPE));
  const auto refined = refine_pose(seen, camera, pose_from({r[0], r[1], r[2]}, {t[0], t[1], t[2]}));
  ASSERT_TRUE(refined);
  error.sum += refined->chi2;
  error.count += view.object.size();
}

TEST(HeldOut, NoWorseThanOpenCvsPipelineWithAsManyCorners) {
  const char* shared = std::getenv("RUNMARK_SHARED");
  const std::filesystem::path folder =
      std::filesystem::path(shared != nullptr ? shared : RUNMARK_SOURCE_DIR "/../shared") /
      "real-images/images";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there: no real frames are read";
  for (const RealSet& set : sets) {
    const Dictionary dictionary = *builtin_dictionary(set.dictionary);
    const Board board = *charuco_board(
        dictionary, {.columns = set.columns, .rows = set.rows, .square = 1, .marker = set.marker});
    std::vector<CalibrationView> ours;
    std::vector<CalibrationView> theirs;
    cv::Size size;
    std::size_t our_corners = 0;
    std::size_t their_corners = 0;
    for (const char* frame : set.frames) {
      const cv::Mat grey =
          cv::imread((folder / (std::string(frame) + ".jpg")).string(), cv::IMREAD_GRAYSCALE);
      ASSERT_FALSE(grey.empty()) << frame;
      size = grey.size();
      const CalibrationView us = seen_by_us(grey, set, board, dictionary);
      const CalibrationView them = seen_by_opencv(grey, set, board);
      our_corners += us.object.size();
      their_corners += them.object.size();
      // OpenCV's calibration takes no view with fewer than four corners, and such a frame cannot be held out.
      if (us.object.size() >= 6) ours.push_back(us);
      if (them.object.size() >= 6) theirs.push_back(them);
    }
    const auto held_out = [](const std::vector<CalibrationView>& views, const auto& find) {
      Error2 error;
      for (std::size_t i = 0; i < views.size(); ++i) {
        std::vector<CalibrationView> others = views;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        add_error(error, views[i], find(others));
      }
      return error;
    };
    const Error2 us = held_out(ours, [&](const auto& views) {
      const auto found = calibrate(views, size.width, size.height, Lens::plain);
      EXPECT_TRUE(found) << set.name << ": " << found.error();
      return found->camera;
    });
    const Error2 them = held_out(theirs, [&](const auto& views) { return camera_by_opencv(views, size); });
    std::printf(
        "%s: held-out error %.3f px over %zu frames, %zu corners; OpenCV's pipeline %.3f px over %zu frames, "
        "%zu corners\n",
        set.name, us.rms(), ours.size(), our_corners, them.rms(), theirs.size(), their_corners);
    EXPECT_LE(us.rms(), them.rms()) << set.name;
    EXPECT_GE(our_corners, their_corners) << set.name;
  }
}

}  // namespace
}  // namespace runmark
