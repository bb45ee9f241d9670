// Whether the predicted 95 % ellipsoids hold the truth as often as they should, over rendered pictures.
#include <gtest/gtest.h>

#include "render/posed_marker.h"
#include "runmark/detector.h"
#include "runmark/pose.h"
#include "support/posed_scene.h"

namespace runmark {
namespace {

// 95 % of chi-square, 6 and 8 degrees of freedom.
constexpr double chi2_of_6 = 12.592;
constexpr double chi2_of_8 = 15.507;

struct Held {
  int cases = 0;
  int corners = 0;  // the corners lie within theirs
  int pose = 0;     // the best pose does, or where it is ambiguous the other one
  int clear = 0;    // poses that are not ambiguous
  int clear_pose = 0;
};

void count(Held& held, const Marker& marker, const CornerCovariance& corners, const render::FrameTruth& truth,
           const render::Scene& scene, int width) {
  std::array<double, 8> off{};
  for (std::size_t i = 0; i < 4; ++i) {
    off[2 * i] = marker.corners[i].x - truth.markers[0].corners[i].x;
    off[2 * i + 1] = marker.corners[i].y - truth.markers[0].corners[i].y;
  }
  ++held.cases;
  held.corners += test::mahalanobis2<8>(corners, off) < chi2_of_8 ? 1 : 0;
  const render::PlanePose& plane = scene.surfaces[1].pose;
  const auto found = pose(marker, width * test::unit_of(plane), test::camera_of(scene.camera), corners);
  ASSERT_TRUE(found) << found.error();
  const Pose exact = test::pose_of(plane, width / 2.0, width / 2.0);
  const auto holds = [&](const PoseSolution& s) {
    return test::mahalanobis2<6>(s.covariance, test::difference(s.pose, exact)) < chi2_of_6;
  };
  const bool best = holds(found->best);
  held.pose += best || (found->other && found->ambiguity > 0.5 && holds(*found->other)) ? 1 : 0;
  if (found->ambiguity > 0.5) return;
  ++held.clear;
  held.clear_pose += best ? 1 : 0;
}

constexpr int scenes = 900;

void expect_held(const char* how, const Held& held) {
  ASSERT_GT(held.cases, scenes * 8 / 10);
  const auto expect = [&](const char* what, int part, int all) {
    const double share = static_cast<double>(part) / all;
    std::printf("%s: the 95 %% ellipsoid holds %s %.3f times of %d\n", how, what, share, all);
    EXPECT_GE(share, 0.90) << how << ", " << what;
    EXPECT_LE(share, 0.98) << how << ", " << what;
  };
  expect("the corners", held.corners, held.cases);
  expect("the pose", held.pose, held.cases);
  expect("the clear pose", held.clear_pose, held.clear);
}

// Seeds other than those the model was fitted with.
TEST(Covariance, HoldsTheTruthAsOftenAsItSays) {
  Held by_marker;
  Held by_picture;
  render::Rng rng(20261125);
  for (const char* name : {"tag36h11", "DICT_4X4_50", "DICT_6X6_250"}) {
    const Dictionary dictionary = *builtin_dictionary(name);
    auto detector = *Detector::create({.max_width = 512, .max_height = 512}, {dictionary});
    for (int i = 0; i < scenes / 3; ++i) {
      const render::Scene scene = render::posed_marker(dictionary, {}, rng);
      const render::RenderedFrame frame = render::render(scene);
      if (frame.truth.markers.size() != 1 || frame.truth.markers[0].cut) continue;
      const auto view = ImageView::grey(frame.grey.data(), frame.width, frame.height, frame.width);
      for (const Marker& marker : detector.detect(view)) {
        if (marker.id != frame.truth.markers[0].id) continue;
        count(by_marker, marker, corner_covariance(marker), frame.truth, scene, dictionary.width);
        count(by_picture, marker, corner_covariance(marker, view), frame.truth, scene, dictionary.width);
      }
    }
  }
  expect_held("marker alone", by_marker);
  expect_held("picture", by_picture);
}

}  // namespace
}  // namespace runmark
