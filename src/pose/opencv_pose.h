#pragma once

#include <opencv2/core/mat.hpp>

#include "runmark/pose.h"

namespace runmark {

/// A pose as OpenCV gives it: three doubles each.
[[nodiscard]] inline Pose pose_from_opencv(const cv::Mat& rotation_vector, const cv::Mat& translation) {
  const auto* r = rotation_vector.ptr<double>();
  const auto* t = translation.ptr<double>();
  return pose_from({r[0], r[1], r[2]}, {t[0], t[1], t[2]});
}

}  // namespace runmark
