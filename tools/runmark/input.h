#pragma once

#include <string>
#include <vector>

namespace runmark::cli {

enum class InputKind { image, video, stream, camera };

/// One thing to read frames from.
struct Input {
  InputKind kind = InputKind::image;
  std::string name;  ///< a path, "-" for standard input, "camera:N" or a /dev/video path

  /// More than one frame may come of it.
  [[nodiscard]] bool moving() const { return kind != InputKind::image; }
};

/// What the command line's INPUT arguments stand for; a folder becomes its images and videos, sorted
/// by name. Throws UserError for one that is not there, cannot be read, or holds nothing to look at.
[[nodiscard]] std::vector<Input> find_inputs(const std::vector<std::string>& arguments);

[[nodiscard]] bool is_image_name(const std::string& path);
[[nodiscard]] bool is_video_name(const std::string& path);

/// What to say after INPUT in a command's help.
inline constexpr const char* input_help =
    "Image files, folders of images and videos, video files, '-' (Y4M or MJPEG on standard input), "
    "cameras (camera:0 or /dev/video0)";

}  // namespace runmark::cli
