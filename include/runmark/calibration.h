#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "runmark/board_view.h"
#include "runmark/camera.h"
#include "runmark/pose.h"

namespace runmark {

/// A picture of a board: places on the board and in the picture, pair by pair.
struct CalibrationView {
  std::string name;  ///< for the reader of the result
  std::vector<Point3> object;
  std::vector<Point> image;
};

/// The chessboard's corners where the board has some, else the markers'. Empty when too little is seen to
/// help.
[[nodiscard]] RUNMARK_EXPORT CalibrationView calibration_view(const Board& board, const BoardView& view,
                                                              std::string name);

/// How well a view agrees with the camera found.
struct CalibratedView {
  Pose pose;
  double error = 0;            ///< rms distance of corners seen and projected, in pixels
  std::vector<Point> offsets;  ///< seen less projected, of each of its corners
  std::vector<bool> used;      ///< corners that agree with the others
  bool outlier = false;        ///< the view as a whole does not: it was left out
};

struct Calibration {
  Camera camera;
  double error = 0;  ///< rms over the corners of the views that were used, in pixels
  /// Standard deviations: fx, fy, cx, cy, then the lens's coefficients; 0 for those held at 0. Empty for a
  /// fisheye lens.
  std::vector<double> deviations;
  std::vector<CalibratedView> views;  ///< as many as were given
};

/// Finds the camera that explains the views. A plain lens is given only the coefficients that the views tell
/// apart from 0: k3 is dropped when it is within its deviation, p1 with p2 when both are within twice theirs.
/// Views and corners that disagree with the rest are left out and marked. The work is done by OpenCV's
/// calibrateCamera and fisheye::calibrate. Errors: fewer than two views, views without 6 corners off one
/// line, a lens that does not fit them.
[[nodiscard]] RUNMARK_EXPORT Result<Calibration> calibrate(std::span<const CalibrationView> views, int width,
                                                           int height, Lens lens);

/// The views that differ from each other most, `most` of them at most, in their order: of a video's many
/// almost equal frames the ones that help.
[[nodiscard]] RUNMARK_EXPORT std::vector<std::size_t> most_different(std::span<const CalibrationView> views,
                                                                     std::size_t most);

}  // namespace runmark
