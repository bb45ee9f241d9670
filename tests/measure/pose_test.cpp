#include "runmark/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cameras.h"
#include "support/posed_scene.h"

namespace runmark {
namespace {

constexpr double size = 0.15;

// The marker as the camera sees it, exactly.
Marker seen(const Camera& camera, const Pose& pose) {
  Marker marker;
  marker.dictionary = "tag36h11";
  marker.id = 7;
  marker.margin = 0.5F;
  const double h = size / 2;
  const std::array corners{Point3{-h, -h, 0}, Point3{h, -h, 0}, Point3{h, h, 0}, Point3{-h, h, 0}};
  for (std::size_t i = 0; i < 4; ++i) marker.corners[i] = camera.project(pose(corners[i])).value();
  return marker;
}

std::vector<Pose> some_poses() {
  std::vector<Pose> poses;
  for (const double tilt : {0.0, 0.2, 0.7, 1.1}) {
    for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
      for (const double spin : {0.1, 1.7, -2.9}) {
        const Pose lean = pose_from({tilt * std::cos(azimuth), tilt * std::sin(azimuth), 0}, {});
        poses.push_back(pose_from({0, 0, 0}, {0.08, -0.05, 0.6}) * lean * pose_from({0, 0, spin}, {}));
      }
    }
  }
  return poses;
}

TEST(Pose, IsExactForExactCornersAndEveryLens) {
  for (const Camera& camera : test::cameras()) {
    for (const Pose& truth : some_poses()) {
      const auto found = pose(seen(camera, truth), size, camera);
      ASSERT_TRUE(found) << found.error();
      EXPECT_LT(found->best.error, 1e-6);
      EXPECT_LT(test::distance_between(found->best.pose, truth), 1e-6);
      EXPECT_LT(test::turn_between(found->best.pose, truth), 1e-5);
    }
  }
}

TEST(Pose, FacingMarkerHasTheIdentityAsRotation) {
  const Camera camera = test::cameras()[0];
  const auto found = pose(seen(camera, pose_from({}, {0, 0, 0.5})), size, camera);
  ASSERT_TRUE(found);
  EXPECT_LT(test::turn_between(found->best.pose, Pose{}), 1e-5);
  EXPECT_NEAR(found->best.pose.translation.z, 0.5, 1e-9);
}

TEST(Pose, FarTiltedMarkerHasTwoAnswersThatLeanOppositeWays) {
  const Camera camera = test::cameras()[0];
  const Pose truth = pose_from({0.5, 0, 0}, {0, 0, 12});
  Marker marker = seen(camera, truth);
  marker.corners[0].x += 0.2;
  marker.corners[2].y += 0.15;
  const auto found = pose(marker, size, camera);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->other);
  EXPECT_GT(found->ambiguity, 0.5);
  EXPECT_LE(found->ambiguity, 1);
  const double turn = test::turn_between(found->best.pose, found->other->pose);
  EXPECT_GT(turn, 0.6);
  EXPECT_LT(
      std::min(test::turn_between(found->best.pose, truth), test::turn_between(found->other->pose, truth)),
      0.2);
}

TEST(Pose, NearTiltedMarkerIsClear) {
  const Camera camera = test::cameras()[0];
  Marker marker = seen(camera, pose_from({0.7, 0, 0}, {0, 0, 0.4}));
  marker.corners[0].x += 0.1;
  const auto found = pose(marker, size, camera);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->other);
  EXPECT_LT(found->ambiguity, 0.05);
  EXPECT_GT(found->other->error, 10 * found->best.error);
}

TEST(Pose, CovarianceIsWhatMovingCornersMakesOfThePose) {
  const Camera camera = test::cameras()[1];
  const Pose truth = pose_from({0.5, 0.3, 0.2}, {0.05, 0.02, 0.5});
  const Marker marker = seen(camera, truth);
  const CornerCovariance corners = corner_covariance(marker);
  const auto found = pose(marker, size, camera, corners);
  ASSERT_TRUE(found);
  // Propagate the corners' covariance through derivatives by differences.
  constexpr double h = 1e-3;
  std::array<std::array<double, 6>, 8> by{};
  for (std::size_t i = 0; i < 8; ++i) {
    Marker moved = marker;
    double& coordinate = i % 2 == 0 ? moved.corners[i / 2].x : moved.corners[i / 2].y;
    coordinate += h;
    const auto there = pose(moved, size, camera, corners);
    ASSERT_TRUE(there);
    by[i] = test::difference(found->best.pose, there->best.pose);
  }
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) {
      double sum = 0;
      for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t j = 0; j < 8; ++j) sum += by[i][a] / h * corners[8 * i + j] * by[j][b] / h;
      }
      const double scale = std::sqrt(found->best.covariance[7 * a] * found->best.covariance[7 * b]);
      EXPECT_NEAR(found->best.covariance[6 * a + b] / scale, sum / scale, 0.02) << a << ' ' << b;
    }
  }
}

TEST(Pose, RefinementWeighsCornersByTheirCovariance) {
  const Camera camera = test::cameras()[0];
  const Pose truth = pose_from({0.5, 0, 0}, {0, 0, 0.5});
  Marker marker = seen(camera, truth);
  marker.corners[2].x += 3;
  CornerCovariance even{};
  CornerCovariance doubtful{};
  for (std::size_t i = 0; i < 8; ++i) even[9 * i] = doubtful[9 * i] = 0.01;
  doubtful[9 * 4] = doubtful[9 * 5] = 100;
  const auto by_even = pose(marker, size, camera, even);
  const auto by_doubt = pose(marker, size, camera, doubtful);
  ASSERT_TRUE(by_even && by_doubt);
  EXPECT_LT(test::turn_between(by_doubt->best.pose, truth), 1e-3);
  EXPECT_GT(test::turn_between(by_even->best.pose, truth), 1e-2);
}

TEST(Pose, TellsWhatIsWrong) {
  const Camera camera = test::cameras()[0];
  const Marker good = seen(camera, pose_from({0.5, 0, 0}, {0, 0, 0.5}));
  EXPECT_NE(pose(good, 0, camera).error().find("size of marker 7 of tag36h11"), std::string::npos);
  EXPECT_NE(pose(good, size, Camera{}).error().find("camera"), std::string::npos);
  Marker crossed = good;
  std::swap(crossed.corners[0], crossed.corners[1]);
  EXPECT_NE(pose(crossed, size, camera).error().find("corners of marker 7"), std::string::npos);
  Marker unknown = good;
  unknown.corners[3].y = std::nan("");
  EXPECT_NE(pose(unknown, size, camera).error().find("corners of marker 7"), std::string::npos);
  EXPECT_NE(pose(good, size, camera, CornerCovariance{}).error().find("covariance"), std::string::npos);
}

TEST(PoseMaths, QuaternionAndRotationVectorAgreeWithTheMatrix) {
  for (const Point3& v :
       {Point3{0, 0, 0}, {0.3, -0.2, 0.9}, {3.1, 0, 0}, {0, 3.1, 0}, {0, 0.1, -3.1}, {1e-9, 0, 0}}) {
    const Pose turned = pose_from(v, {1, 2, 3});
    const Point3 back = rotation_vector(turned);
    EXPECT_NEAR(back.x, v.x, 1e-9);
    EXPECT_NEAR(back.y, v.y, 1e-9);
    EXPECT_NEAR(back.z, v.z, 1e-9);
    const auto [x, y, z, w] = quaternion(turned);
    EXPECT_NEAR(x * x + y * y + z * z + w * w, 1, 1e-12);
    EXPECT_GE(w, 0);
    EXPECT_NEAR(1 - 2 * (y * y + z * z), turned.rotation[0], 1e-12);
    EXPECT_NEAR(2 * (x * y - w * z), turned.rotation[1], 1e-12);
  }
}

TEST(PoseMaths, InverseAndProductUndoEachOther) {
  const Pose a = pose_from({0.3, -0.2, 0.9}, {1, 2, 3});
  const Pose b = pose_from({-1, 0.5, 0.1}, {-2, 0.3, 5});
  const Pose back = a.inverse() * (a * b);
  EXPECT_LT(test::turn_between(back, b), 1e-12);
  EXPECT_LT(test::distance_between(back, b), 1e-12);
  const Point3 p = (a * b)({0.1, 0.2, 0.3});
  const Point3 q = a(b({0.1, 0.2, 0.3}));
  EXPECT_NEAR(p.x, q.x, 1e-12);
  EXPECT_NEAR(p.z, q.z, 1e-12);
}

}  // namespace
}  // namespace runmark
