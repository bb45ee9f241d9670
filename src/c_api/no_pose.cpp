// In the place of pose.cpp where the library is built without runmark::measure.
#include "c_api/guard.h"

using runmark::c_api::fail;

runmark_status runmark_camera_load(const char* /*path*/, runmark_camera* /*camera*/, runmark_error* error) {
  return fail(error, RUNMARK_UNAVAILABLE);
}

runmark_status runmark_marker_pose(const runmark_marker* /*marker*/, double /*size*/,
                                   const runmark_camera* /*camera*/, const runmark_image* /*image*/,
                                   runmark_pose_estimate* /*estimate*/, runmark_error* error) {
  return fail(error, RUNMARK_UNAVAILABLE);
}

runmark_status runmark_board_load(const char* /*description_or_path*/, runmark_board** board,
                                  runmark_error* error) {
  if (board != nullptr) *board = nullptr;
  return fail(error, RUNMARK_UNAVAILABLE);
}

void runmark_board_free(runmark_board* /*board*/) {}

runmark_status runmark_board_pose(const runmark_board* /*board*/, const runmark_detector* /*detector*/,
                                  const runmark_image* /*image*/, const runmark_camera* /*camera*/,
                                  runmark_pose_estimate* /*estimate*/, runmark_error* error) {
  return fail(error, RUNMARK_UNAVAILABLE);
}
