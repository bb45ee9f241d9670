#pragma once

#include <opencv2/videoio.hpp>
#include <string>

#include "frame_source.h"

namespace runmark::cli {

/// A video file, decoded by OpenCV.
class VideoSource : public FrameSource {
 public:
  explicit VideoSource(std::string path);
  [[nodiscard]] std::optional<Frame> next() override;
  [[nodiscard]] std::optional<std::int64_t> frame_count() const override;
  [[nodiscard]] bool complete_after(std::int64_t frames) const override;
  [[nodiscard]] std::optional<double> frame_rate() const override;

 private:
  std::string path_;
  cv::VideoCapture capture_;
  std::int64_t index_ = 0;
};

/// A camera: endless until it is unplugged.
class CameraSource : public FrameSource {
 public:
  /// "camera:N" or the path of a video device.
  explicit CameraSource(std::string name);
  [[nodiscard]] std::optional<Frame> next() override;
  [[nodiscard]] std::optional<double> frame_rate() const override;

 private:
  std::string name_;
  cv::VideoCapture capture_;
  std::int64_t index_ = 0;
};

}  // namespace runmark::cli
