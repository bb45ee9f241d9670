#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "detector_settings.h"
#include "frame.h"
#include "pose_settings.h"
#include "runmark/board_view.h"
#include "runmark/camera.h"
#include "runmark/marker_sizes.h"
#include "runmark/pose.h"

namespace runmark::cli {

/// The picture of an object's axes: origin, x, y, z.
using AxesPicture = std::array<Point, 4>;

/// What a frame tells of poses.
struct FramePoses {
  std::vector<std::optional<PoseEstimate>> markers;  ///< as many as markers were found
  bool has_board = false;                            ///< a board was asked for
  BoardView board;
  std::optional<PoseEstimate> board_pose;
  std::string advice;  ///< see layout_advice
  std::vector<AxesPicture> axes;
};

/// Finds the poses that the command line asks for. May be used by several threads.
class PoseFinder {
 public:
  /// Throws UserError for a file that cannot be read and options that do not go together.
  explicit PoseFinder(const PoseSettings& settings);

  /// The dictionaries of the board are looked for as well.
  void add_dictionaries(DetectorSettings& detector) const;

  [[nodiscard]] bool has_poses() const { return camera_.has_value(); }
  [[nodiscard]] bool is_idle() const { return !camera_ && !board_; }

  /// Throws InputError for a frame of another size than the camera's.
  [[nodiscard]] FramePoses find(const Frame& frame, std::span<const Marker> markers) const;

 private:
  void add_axes(FramePoses& poses, const Pose& pose, double length) const;

  std::optional<Camera> camera_;
  MarkerSizes sizes_;
  std::optional<Board> board_;
};

}  // namespace runmark::cli
