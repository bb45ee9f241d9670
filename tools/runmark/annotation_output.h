#pragma once

#include <memory>
#include <opencv2/videoio.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "frame.h"
#include "input.h"
#include "pose_finder.h"
#include "runmark/marker.h"

namespace runmark::cli {

/// Where --annotate puts its pictures: one image, one video, or a folder with a picture or video for
/// each input, named after it.
class AnnotationOutput {
 public:
  /// Throws UserError when `path` does not suit the inputs, or would replace one of them.
  AnnotationOutput(std::string path, const std::vector<Input>& inputs);

  /// The next input begins. `rate` is that of a video's frames.
  void begin(const Input& input, double rate);
  void write(const Frame& frame, std::span<const Marker> markers, std::span<const AxesPicture> axes);
  /// Closes the input's video and sees that all of it is there.
  void end();

 private:
  [[nodiscard]] std::string path_for(const Input& input);
  void check_not_an_input(const std::string& path) const;
  void write_video_frame(const cv::Mat& picture);

  std::string path_;
  const std::vector<Input>& inputs_;
  bool is_folder_ = false;
  std::set<std::string> used_names_;

  std::string current_;  ///< the picture or video being written
  double rate_ = 0;
  cv::VideoWriter video_;
  cv::Size video_size_;
  std::int64_t video_frames_ = 0;
};

}  // namespace runmark::cli
