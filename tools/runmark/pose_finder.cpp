#include "pose_finder.h"

#include <cmath>

#include "errors.h"
#include "runmark/board_file.h"
#include "runmark/camera_file.h"

namespace runmark::cli {
namespace {

/// For the length of the axes drawn.
double marker_side(const Board& board) {
  const auto& c = board.markers[0].corners;
  return std::hypot(c[1].x - c[0].x, c[1].y - c[0].y, c[1].z - c[0].z);
}

}  // namespace

PoseFinder::PoseFinder(const PoseSettings& settings)
    : sizes_(value_or_throw(MarkerSizes::parse(settings.sizes))) {
  if (!settings.camera.empty()) camera_ = value_or_throw(read_camera(settings.camera));
  if (!settings.board.empty()) board_ = value_or_throw(load_board(settings.board));
  if (!camera_ && !settings.sizes.empty()) throw UserError("--marker-size needs --camera-info");
  if (camera_ && settings.sizes.empty() && !board_)
    throw UserError("--camera-info needs --marker-size or --board");
}

void PoseFinder::add_dictionaries(DetectorSettings& detector) const {
  if (board_) add_dictionaries_of(*board_, detector);
}

FramePoses PoseFinder::find(const Frame& frame, std::span<const Marker> markers) const {
  if (camera_ && camera_->width > 0 && camera_->height > 0 &&
      (camera_->width != frame.pixels.cols || camera_->height != frame.pixels.rows)) {
    throw InputError(frame.source + ": is " + std::to_string(frame.pixels.cols) + " x " +
                     std::to_string(frame.pixels.rows) + " pixels, but the camera file is for " +
                     std::to_string(camera_->width) + " x " + std::to_string(camera_->height));
  }
  const ImageView view = frame.view();
  FramePoses poses;
  for (const Marker& marker : markers) {
    std::optional<PoseEstimate>& found = poses.markers.emplace_back();
    const std::optional<double> size = sizes_.of(marker);
    if (!camera_ || !size) continue;
    const Result<PoseEstimate> estimate = pose(marker, *size, *camera_, corner_covariance(marker, view));
    if (!estimate) continue;  // a quadrilateral that no square before this camera has
    found = *estimate;
    add_axes(poses, found->best.pose, *size / 2);
  }
  if (board_) {
    poses.has_board = true;
    poses.board = view_board(*board_, markers, view);
    poses.advice = layout_advice(*board_, markers);
    if (camera_) {
      const Result<PoseEstimate> estimate = pose(*board_, poses.board, *camera_);
      if (estimate) {
        poses.board_pose = *estimate;
        add_axes(poses, poses.board_pose->best.pose, 2 * marker_side(*board_));
      }
    }
  }
  return poses;
}

void PoseFinder::add_axes(FramePoses& poses, const Pose& pose, double length) const {
  const std::array<Point3, 4> ends{Point3{0, 0, 0}, {length, 0, 0}, {0, length, 0}, {0, 0, length}};
  AxesPicture picture;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::optional<Point> p = camera_->project(pose(ends[i]));
    if (!p) return;
    picture[i] = *p;
  }
  poses.axes.push_back(picture);
}

}  // namespace runmark::cli
