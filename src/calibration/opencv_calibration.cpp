#include "calibration/opencv_calibration.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>

#include "pose/opencv_pose.h"

namespace runmark {
namespace {

struct Points {
  std::vector<std::vector<cv::Point3f>> object;
  std::vector<std::vector<cv::Point2f>> image;
  bool flat = true;
};

Points points_of(const std::vector<const CalibrationView*>& views) {
  Points points;
  for (const CalibrationView* view : views) {
    auto& object = points.object.emplace_back();
    auto& image = points.image.emplace_back();
    for (const Point3& p : view->object) {
      object.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
      points.flat = points.flat && p.z == 0;
    }
    for (const Point& p : view->image) image.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  return points;
}

std::vector<Pose> poses_of(const std::vector<cv::Mat>& turns, const std::vector<cv::Mat>& places) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    poses.push_back(pose_from_opencv(turns[i], places[i]));
  }
  return poses;
}

Camera camera_from(const cv::Matx33d& k, const cv::Mat& d, int width, int height, Lens lens) {
  Camera camera{width, height, k(0, 0), k(1, 1), k(0, 2), k(1, 2), lens, {}};
  const int count = std::min(static_cast<int>(d.total()), coefficients_of(lens));
  for (int i = 0; i < count; ++i) camera.distortion[static_cast<std::size_t>(i)] = d.ptr<double>()[i];
  return camera;
}

RawCalibration by_polynomial(const Points& points, int width, int height, Lens lens, HeldCoefficients held) {
  int flags = lens == Lens::rational ? cv::CALIB_RATIONAL_MODEL : 0;
  if (lens == Lens::plain && held.k3) flags |= cv::CALIB_FIX_K3;
  if (lens == Lens::plain && held.tangential) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  cv::Matx33d k = cv::Matx33d::eye();
  if (!points.flat) {
    flags |= cv::CALIB_USE_INTRINSIC_GUESS;
    k = {static_cast<double>(width),
         0,
         (width - 1) / 2.0,
         0,
         static_cast<double>(width),
         (height - 1) / 2.0,
         0,
         0,
         1};
  }
  cv::Mat d;
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> places;
  cv::Mat deviations;
  const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-10);
  cv::calibrateCamera(points.object, points.image, {width, height}, k, d, turns, places, deviations,
                      cv::noArray(), cv::noArray(), flags, until);
  RawCalibration raw{camera_from(k, d, width, height, lens), {}, poses_of(turns, places)};
  const auto* values = deviations.ptr<double>();
  raw.deviations.assign(values, values + 4 + coefficients_of(lens));
  return raw;
}

RawCalibration by_fisheye(const Points& points, int width, int height) {
  cv::Matx33d k(width / 2.0, 0, (width - 1) / 2.0, 0, width / 2.0, (height - 1) / 2.0, 0, 0, 1);
  cv::Mat d = cv::Mat::zeros(4, 1, CV_64F);
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> places;
  const int flags = cv::fisheye::CALIB_RECOMPUTE_EXTRINSIC | cv::fisheye::CALIB_FIX_SKEW |
                    cv::fisheye::CALIB_USE_INTRINSIC_GUESS;
  const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-10);
  // It wants doubles.
  std::vector<std::vector<cv::Point3d>> object;
  std::vector<std::vector<cv::Point2d>> image;
  for (const auto& view : points.object) object.emplace_back(view.begin(), view.end());
  for (const auto& view : points.image) image.emplace_back(view.begin(), view.end());
  cv::fisheye::calibrate(object, image, {width, height}, k, d, turns, places, flags, until);
  return {camera_from(k, d, width, height, Lens::fisheye), {}, poses_of(turns, places)};
}

}  // namespace

Result<RawCalibration> calibrate_by_opencv(const std::vector<const CalibrationView*>& views, int width,
                                           int height, Lens lens, HeldCoefficients held) {
  try {
    const Points points = points_of(views);
    RawCalibration raw = lens == Lens::fisheye ? by_fisheye(points, width, height)
                                               : by_polynomial(points, width, height, lens, held);
    if (!raw.camera.is_valid()) return Error{"no camera with this kind of lens explains the views"};
    return raw;
  } catch (const cv::Exception&) {
    return Error{"no camera with this kind of lens explains the views"};
  }
}

}  // namespace runmark
