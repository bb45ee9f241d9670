#pragma once

#include <string>
#include <string_view>

#include "runmark/camera.h"
#include "runmark/export.h"
#include "runmark/result.h"

namespace runmark {

/// How a camera is written down.
enum class CameraFormat {
  opencv,  ///< YAML as OpenCV's FileStorage and its calibration sample write it
  ros,     ///< YAML of ROS's camera_calibration, which camera_info_manager reads
};

/// Reads the text of a camera file: YAML of OpenCV or of ROS, or a printed sensor_msgs/CameraInfo (K and D);
/// which of them is told by its keys. Errors say what is missing or wrong.
[[nodiscard]] RUNMARK_EXPORT Result<Camera> parse_camera(std::string_view text);

/// The same from a file; errors begin with its path.
[[nodiscard]] RUNMARK_EXPORT Result<Camera> read_camera(const std::string& path);

/// The text of a camera file.
/// @param error  rms reprojection error of the calibration in pixels, noted in the file; negative: not known
/// @param name   of the camera; for ROS
[[nodiscard]] RUNMARK_EXPORT std::string camera_text(const Camera& camera, CameraFormat format,
                                                     double error = -1, std::string_view name = "camera");

}  // namespace runmark
