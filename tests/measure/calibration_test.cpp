#include "runmark/calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/cameras.h"

namespace runmark {
namespace {

// Views of a 7 x 5 grid of corners as the camera has them, with a little noise.
std::vector<CalibrationView> views_by(const Camera& camera, int count, double noise) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(-1, 1);
  std::vector<CalibrationView> views;
  while (static_cast<int>(views.size()) < count) {
    const Pose pose = pose_from({0.5 * even(random), 0.5 * even(random), even(random)},
                                {0.12 * even(random), 0.1 * even(random), 0.35 + 0.1 * even(random)});
    CalibrationView view{"view " + std::to_string(views.size()), {}, {}};
    for (int row = 0; row < 5; ++row) {
      for (int column = 0; column < 7; ++column) {
        const Point3 place{0.04 * (column - 3), 0.04 * (row - 2), 0};
        const std::optional<Point> p = camera.project(pose(place));
        if (!p || p->x < 0 || p->y < 0 || p->x > camera.width - 1 || p->y > camera.height - 1) continue;
        view.object.push_back(place);
        view.image.push_back({p->x + noise * normal(random), p->y + noise * normal(random)});
      }
    }
    if (view.object.size() > 20) views.push_back(view);
  }
  return views;
}

TEST(Calibrate, FindsTheCameraOfEveryLens) {
  for (const Camera& camera : test::cameras()) {
    if (camera.distortion[8] != 0) continue;  // thin prisms are read, not calibrated
    const auto views = views_by(camera, 15, 0.02);
    const auto found = calibrate(views, camera.width, camera.height, camera.lens);
    ASSERT_TRUE(found) << found.error();
    EXPECT_LT(found->error, 0.04);
    EXPECT_NEAR(found->camera.fx, camera.fx, 0.005 * camera.fx);
    EXPECT_NEAR(found->camera.cx, camera.cx, 2);
    EXPECT_EQ(found->camera.lens, camera.lens);
    EXPECT_EQ(found->views.size(), views.size());
    for (const CalibratedView& view : found->views) EXPECT_FALSE(view.outlier);
  }
}

TEST(Calibrate, DropsCoefficientsThatTheViewsDoNotTellFromZero) {
  Camera camera = test::cameras()[0];
  camera.distortion = {-0.2, 0.05};
  const auto found = calibrate(views_by(camera, 6, 0.05), camera.width, camera.height, Lens::plain);
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->camera.distortion[4], 0);
  EXPECT_EQ(found->camera.distortion[2], 0);
  EXPECT_NEAR(found->camera.distortion[0], -0.2, 0.02);
}

TEST(Calibrate, NamesABadViewAndABadCorner) {
  const Camera camera = test::cameras()[1];
  auto views = views_by(camera, 12, 0.03);
  for (std::size_t i = 0; i < views[4].image.size(); ++i) views[4].image[i].x += i % 2 == 0 ? 3 : -3;
  views[7].image[11].y += 4;
  const auto found = calibrate(views, camera.width, camera.height, Lens::plain);
  ASSERT_TRUE(found) << found.error();
  for (std::size_t i = 0; i < views.size(); ++i) EXPECT_EQ(found->views[i].outlier, i == 4) << i;
  EXPECT_FALSE(found->views[7].used[11]);
  EXPECT_NEAR(found->views[7].offsets[11].y, 4, 0.5);
  EXPECT_LT(found->error, 0.06);
}

TEST(Calibrate, ChoosesTheViewsThatDifferMost) {
  const Camera camera = test::cameras()[0];
  auto views = views_by(camera, 4, 0);
  std::vector<CalibrationView> many;
  for (const CalibrationView& view : views) {
    for (int copy = 0; copy < 5; ++copy) many.push_back(view);
  }
  const std::vector<std::size_t> chosen = most_different(many, 4);
  ASSERT_EQ(chosen.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(chosen[i] / 5, i);
  EXPECT_EQ(most_different(many, 10).size(), 4U);  // the copies add nothing
  EXPECT_TRUE(most_different({}, 3).empty());
}

TEST(Calibrate, TellsWhatIsWrong) {
  const Camera camera = test::cameras()[0];
  auto views = views_by(camera, 3, 0);
  EXPECT_NE(calibrate({views.data(), 1}, 640, 480, Lens::plain).error().find("at least two views"),
            std::string::npos);
  views[1].object.resize(4);
  views[1].image.resize(4);
  EXPECT_NE(calibrate(views, 640, 480, Lens::plain).error().find("view 1: too little"), std::string::npos);
  EXPECT_NE(calibrate(views, 0, 480, Lens::plain).error().find("pixel"), std::string::npos);
}

}  // namespace
}  // namespace runmark
