#include "bench/pose/methods.h"

#include <apriltag/apriltag_pose.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <opencv2/calib3d.hpp>

namespace runmark::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

class RunmarkPose : public PoseMethod {
 public:
  [[nodiscard]] std::string_view name() const override { return "runmark"; }
  [[nodiscard]] std::optional<Pose> find(const cv::Mat& grey, int id, double size,
                                         const Camera& camera) override {
    const auto view =
        ImageView::grey(grey.data, grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step[0]));
    for (const Marker& marker : detector_.detect(view)) {
      if (marker.id != id) continue;
      const auto start = Clock::now();
      const Result<PoseEstimate> estimate = pose(marker, size, camera, corner_covariance(marker, view));
      time_ += since(start);
      ++calls_;
      if (estimate) return estimate->best.pose;
    }
    return {};
  }

 private:
  Detector detector_ =
      *Detector::create({.max_width = 512, .max_height = 512}, {*builtin_dictionary("tag36h11")});
};

class OpenCvPose : public PoseMethod {
 public:
  OpenCvPose() { parameters_->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX; }
  [[nodiscard]] std::string_view name() const override { return "OpenCV"; }
  [[nodiscard]] std::optional<Pose> find(const cv::Mat& grey, int id, double size,
                                         const Camera& camera) override {
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    cv::aruco::detectMarkers(grey, dictionary_, corners, ids, parameters_);
    const auto found = std::find(ids.begin(), ids.end(), id);
    if (found == ids.end()) return {};
    const double h = size / 2;
    const std::vector<cv::Point3d> object{{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
    const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    cv::Vec3d r;
    cv::Vec3d t;
    const auto start = Clock::now();
    const bool solved = cv::solvePnP(object, corners[static_cast<std::size_t>(found - ids.begin())], k,
                                     cv::noArray(), r, t, false, cv::SOLVEPNP_IPPE_SQUARE);
    time_ += since(start);
    ++calls_;
    if (!solved) return {};
    // Its y goes up and z out of the marker, and its AprilTag dictionary is turned by 180 degrees: x goes
    // left.
    const Pose theirs = pose_from({r[0], r[1], r[2]}, {t[0], t[1], t[2]});
    return theirs * Pose{{-1, 0, 0, 0, 1, 0, 0, 0, -1}, {}};
  }

 private:
  cv::Ptr<cv::aruco::Dictionary> dictionary_ =
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  cv::Ptr<cv::aruco::DetectorParameters> parameters_ = cv::aruco::DetectorParameters::create();
};

class AprilTagPose : public PoseMethod {
 public:
  AprilTagPose() {
    detector_->quad_decimate = 1;
    detector_->nthreads = 1;
    apriltag_detector_add_family(detector_, family_);
  }
  ~AprilTagPose() override {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  [[nodiscard]] std::string_view name() const override { return "AprilTag 3"; }
  [[nodiscard]] std::optional<Pose> find(const cv::Mat& grey, int id, double size,
                                         const Camera& camera) override {
    image_u8_t image{grey.cols, grey.rows, static_cast<int>(grey.step[0]), grey.data};
    zarray_t* found = apriltag_detector_detect(detector_, &image);
    std::optional<Pose> result;
    for (int i = 0; i < zarray_size(found); ++i) {
      apriltag_detection_t* detection = nullptr;
      zarray_get(found, i, &detection);
      if (detection->id != id || result) continue;
      // Its pixel centres are half a pixel farther.
      apriltag_detection_info_t info{detection, size, camera.fx, camera.fy, camera.cx + 0.5, camera.cy + 0.5};
      apriltag_pose_t estimate{};
      const auto start = Clock::now();
      estimate_tag_pose(&info, &estimate);
      time_ += since(start);
      ++calls_;
      Pose pose;
      std::copy_n(estimate.R->data, 9, pose.rotation.begin());
      pose.translation = {estimate.t->data[0], estimate.t->data[1], estimate.t->data[2]};
      // Debian's library does not export matd_destroy, which frees its one block.
      std::free(estimate.R);
      std::free(estimate.t);
      result = pose;
    }
    apriltag_detections_destroy(found);
    return result;
  }

 private:
  apriltag_detector_t* detector_ = apriltag_detector_create();
  apriltag_family_t* family_ = tag36h11_create();
};

}  // namespace

std::unique_ptr<PoseMethod> runmark_pose() { return std::make_unique<RunmarkPose>(); }
std::unique_ptr<PoseMethod> opencv_pose() { return std::make_unique<OpenCvPose>(); }
std::unique_ptr<PoseMethod> apriltag_pose() { return std::make_unique<AprilTagPose>(); }

}  // namespace runmark::bench
