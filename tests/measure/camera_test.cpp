#include "runmark/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "camera/lens.h"
#include "support/cameras.h"

namespace runmark {
namespace {

Point project_by_opencv(const Camera& camera, const Point3& p) {
  const std::vector<cv::Point3d> object{{p.x, p.y, p.z}};
  const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> d(camera.distortion.begin(),
                              camera.distortion.begin() + coefficients_of(camera.lens));
  std::vector<cv::Point2d> image;
  if (camera.lens == Lens::fisheye) {
    cv::fisheye::projectPoints(object, image, cv::Vec3d(), cv::Vec3d(), k, d);
  } else {
    cv::projectPoints(object, cv::Vec3d(), cv::Vec3d(), k, d, image);
  }
  return {image[0].x, image[0].y};
}

TEST(Camera, ProjectsAsOpenCv) {
  for (const Camera& camera : test::cameras()) {
    for (double x = -0.6; x <= 0.6; x += 0.15) {
      for (double y = -0.4; y <= 0.4; y += 0.1) {
        const Point3 p{2 * x, 2 * y, 2};
        const std::optional<Point> ours = camera.project(p);
        ASSERT_TRUE(ours);
        const Point theirs = project_by_opencv(camera, p);
        EXPECT_NEAR(ours->x, theirs.x, 1e-9);
        EXPECT_NEAR(ours->y, theirs.y, 1e-9);
      }
    }
  }
}

TEST(Camera, DirectionIsTheInverseOverTheWholePicture) {
  for (const Camera& camera : test::cameras()) {
    for (int x = 0; x < camera.width; x += 21) {
      for (int y = 0; y < camera.height; y += 21) {
        const Point pixel{static_cast<double>(x), static_cast<double>(y)};
        const std::optional<Point> d = camera.direction(pixel);
        ASSERT_TRUE(d) << x << ' ' << y << " lens " << static_cast<int>(camera.lens);
        const std::optional<Point> back = camera.project({3 * d->x, 3 * d->y, 3});
        EXPECT_NEAR(back->x, pixel.x, 1e-6);
        EXPECT_NEAR(back->y, pixel.y, 1e-6);
      }
    }
  }
}

TEST(Camera, DerivativesOfTheLensAreThoseOfItsValues) {
  constexpr double h = 1e-6;
  for (const Camera& camera : test::cameras()) {
    for (const Point p : {Point{0, 0}, {0.3, -0.2}, {-0.5, 0.4}, {0.01, 0.6}}) {
      const Bent bent = bend(camera, p);
      const Bent right = bend(camera, {p.x + h, p.y});
      const Bent left = bend(camera, {p.x - h, p.y});
      const Bent below = bend(camera, {p.x, p.y + h});
      const Bent above = bend(camera, {p.x, p.y - h});
      EXPECT_NEAR(bent.by[0], (right.at.x - left.at.x) / (2 * h), 1e-6);
      EXPECT_NEAR(bent.by[1], (below.at.x - above.at.x) / (2 * h), 1e-6);
      EXPECT_NEAR(bent.by[2], (right.at.y - left.at.y) / (2 * h), 1e-6);
      EXPECT_NEAR(bent.by[3], (below.at.y - above.at.y) / (2 * h), 1e-6);
    }
  }
}

TEST(Camera, SeesNothingBehindIt) {
  const Camera camera = test::cameras()[0];
  EXPECT_FALSE(camera.project({0, 0, 0}));
  EXPECT_FALSE(camera.project({0.1, 0.1, -1}));
  EXPECT_FALSE(camera.project({0, 0, std::nan("")}));
}

TEST(Camera, HasNoDirectionBeyondTheLensModel) {
  Camera camera = test::cameras()[0];
  // A barrel whose pictures fold back 0.58 from the centre.
  camera.distortion = {-0.45, 0, 0, 0, 0};
  EXPECT_TRUE(camera.direction({camera.cx + 0.5 * camera.fx, camera.cy}));
  EXPECT_FALSE(camera.direction({camera.cx + 0.7 * camera.fx, camera.cy}));
}

TEST(Camera, IsValidWithFiniteNumbersAndPositiveFocalLengths) {
  Camera camera = test::cameras()[0];
  EXPECT_TRUE(camera.is_valid());
  camera.fx = 0;
  EXPECT_FALSE(camera.is_valid());
  camera.fx = std::nan("");
  EXPECT_FALSE(camera.is_valid());
  EXPECT_FALSE(Camera{}.is_valid());
}

}  // namespace
}  // namespace runmark
