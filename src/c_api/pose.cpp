#include "runmark/pose.h"

#include <algorithm>
#include <array>
#include <optional>

#include "c_api/guard.h"
#include "c_api/handles.h"
#include "c_api/image.h"
#include "runmark/board_file.h"
#include "runmark/board_view.h"
#include "runmark/camera_file.h"

struct runmark_board {
  runmark::Board value;
};

namespace {

using namespace runmark;
using namespace runmark::c_api;

constexpr std::array lenses{Lens::plain, Lens::rational, Lens::fisheye};

std::optional<Camera> to_camera(const runmark_camera& c) {
  const unsigned lens = number(c.lens);
  if (lens >= lenses.size()) return std::nullopt;
  Camera camera{c.width, c.height, c.fx, c.fy, c.cx, c.cy, lenses[lens], {}};
  std::copy_n(c.distortion, camera.distortion.size(), camera.distortion.begin());
  return camera;
}

Marker to_marker(const runmark_marker& c) {
  Marker marker;
  marker.dictionary = c.dictionary == nullptr ? "" : c.dictionary;
  marker.id = c.id;
  for (std::size_t i = 0; i < 4; ++i) marker.corners[i] = {c.corners[i][0], c.corners[i][1]};
  marker.hamming = c.hamming;
  marker.margin = c.margin;
  marker.inverted = c.inverted != 0;
  marker.row = c.row;
  return marker;
}

runmark_pose to_c(const PoseSolution& solution) {
  runmark_pose pose{};
  std::ranges::copy(solution.pose.rotation, pose.rotation);
  const Point3& t = solution.pose.translation;
  pose.translation[0] = t.x;
  pose.translation[1] = t.y;
  pose.translation[2] = t.z;
  pose.error = solution.error;
  std::ranges::copy(solution.covariance, pose.covariance);
  return pose;
}

runmark_status give(const Result<PoseEstimate>& result, runmark_pose_estimate* estimate,
                    runmark_error* error) {
  if (!result) return fail(error, RUNMARK_NO_POSE, result.error());
  *estimate = {};
  estimate->best = to_c(result->best);
  if (result->other) estimate->other = to_c(*result->other);
  estimate->has_other = result->other ? 1 : 0;
  estimate->ambiguity = result->ambiguity;
  return RUNMARK_OK;
}

}  // namespace

runmark_status runmark_camera_load(const char* path, runmark_camera* camera, runmark_error* error) {
  return guarded(error, [&] {
    if (path == nullptr || camera == nullptr) return fail(error, RUNMARK_BAD_ARGUMENT);
    const Result<Camera> read = read_camera(path);
    if (!read) return fail(error, RUNMARK_FAILED, read.error());
    const Camera& c = *read;
    *camera = {c.width, c.height, c.fx, c.fy, c.cx, c.cy, static_cast<runmark_lens>(c.lens), {}};
    std::ranges::copy(c.distortion, camera->distortion);
    return RUNMARK_OK;
  });
}

runmark_status runmark_marker_pose(const runmark_marker* marker, double size, const runmark_camera* camera,
                                   const runmark_image* image, runmark_pose_estimate* estimate,
                                   runmark_error* error) {
  return guarded(error, [&] {
    if (marker == nullptr || camera == nullptr || estimate == nullptr)
      return fail(error, RUNMARK_BAD_ARGUMENT);
    const std::optional<Camera> c = to_camera(*camera);
    if (!c) return fail(error, RUNMARK_BAD_ARGUMENT);
    const Marker m = to_marker(*marker);
    if (image == nullptr) return give(pose(m, size, *c), estimate, error);
    const std::optional<ImageView> view = to_view(*image);
    if (!view || view->check() != Status::ok) return fail(error, RUNMARK_BAD_VIEW);
    return give(pose(m, size, *c, corner_covariance(m, *view)), estimate, error);
  });
}

runmark_status runmark_board_load(const char* description_or_path, runmark_board** board,
                                  runmark_error* error) {
  return guarded(error, [&] {
    if (description_or_path == nullptr || board == nullptr) return fail(error, RUNMARK_BAD_ARGUMENT);
    *board = nullptr;
    Result<Board> loaded = load_board(description_or_path);
    if (!loaded) return fail(error, RUNMARK_FAILED, loaded.error());
    *board = new runmark_board{*std::move(loaded)};
    return RUNMARK_OK;
  });
}

void runmark_board_free(runmark_board* board) { delete board; }

runmark_status runmark_board_pose(const runmark_board* board, const runmark_detector* detector,
                                  const runmark_image* image, const runmark_camera* camera,
                                  runmark_pose_estimate* estimate, runmark_error* error) {
  return guarded(error, [&] {
    const bool given = board != nullptr && detector != nullptr && image != nullptr && camera != nullptr;
    if (!given || estimate == nullptr) return fail(error, RUNMARK_BAD_ARGUMENT);
    const std::optional<Camera> c = to_camera(*camera);
    if (!c) return fail(error, RUNMARK_BAD_ARGUMENT);
    const std::optional<ImageView> view = to_view(*image);
    if (!view || view->check() != Status::ok) return fail(error, RUNMARK_BAD_VIEW);
    return give(pose(board->value, view_board(board->value, detector->value.markers(), *view), *c), estimate,
                error);
  });
}
