#include "checks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The path of a file with that text. */
static const char* write_text(const char* folder, const char* name, const char* text) {
  static char path[1000];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE* file = fopen(path, "w");
  if (file == NULL || fputs(text, file) == EOF) exit(99);
  fclose(file);
  return path;
}

static void check_identity(const double* rotation) {
  for (int i = 0; i < 9; ++i) CHECK(fabs(rotation[i] - (i % 4 == 0 ? 1 : 0)) < 0.02);
}

/* The picture shows two upright markers from the front: as if the unit were what a pixel sees at z = 600. */
void test_poses(const picture* p, const char* folder) {
  runmark_error error;
  runmark_camera camera;
  const char* file =
      write_text(folder, "camera.yaml",
                 "image_width: 320\nimage_height: 240\ndistortion_model: plumb_bob\n"
                 "camera_matrix: {rows: 3, cols: 3, data: [600, 0, 159.5, 0, 600, 119.5, 0, 0, 1]}\n"
                 "distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}\n");
  const runmark_status loaded = runmark_camera_load(file, &camera, &error);
  if (loaded == RUNMARK_UNAVAILABLE) {
    printf("poses: %s\n", error.message);
    return;
  }
  CHECK(loaded == RUNMARK_OK);
  CHECK(camera.width == 320 && camera.fx == 600 && camera.cy == 119.5 && camera.lens == RUNMARK_LENS_PLAIN);
  CHECK(runmark_camera_load("/no/camera.yaml", &camera, &error) == RUNMARK_FAILED);
  CHECK(strstr(error.message, "/no/camera.yaml") != NULL);
  CHECK(runmark_camera_load(NULL, &camera, &error) == RUNMARK_BAD_ARGUMENT);

  const runmark_options options = default_options();
  runmark_detector* detector = make(&options, "tag36h11");
  const runmark_image frame = runmark_grey_image(p->grey, p->width, p->height, p->width);
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);
  runmark_marker markers[max_markers];
  CHECK(all_markers(detector, markers) == 2);
  runmark_pose_estimate estimate;
  const runmark_image* images[2] = {&frame, NULL};
  for (int i = 0; i < 2; ++i) {
    CHECK(runmark_marker_pose(&markers[0], 48, &camera, images[i], &estimate, &error) == RUNMARK_OK);
    CHECK(fabs(estimate.best.translation[0] - (69.5 - 159.5)) < 1);
    CHECK(fabs(estimate.best.translation[1] - (49.5 - 119.5)) < 1);
    CHECK(fabs(estimate.best.translation[2] - 600) < 5);
    CHECK(estimate.best.error >= 0 && estimate.best.error < 0.2);
    CHECK(estimate.best.covariance[0] > 0 && estimate.best.covariance[14] > estimate.best.covariance[0]);
    CHECK(estimate.has_other == 0 || (estimate.ambiguity >= 0 && estimate.ambiguity <= 1));
  }
  CHECK(runmark_marker_pose(&markers[0], 0, &camera, NULL, &estimate, &error) == RUNMARK_NO_POSE);
  CHECK(strstr(error.message, "size of marker 7 of tag36h11") != NULL);
  CHECK(runmark_marker_pose(NULL, 48, &camera, NULL, &estimate, &error) == RUNMARK_BAD_ARGUMENT);
  runmark_camera wrong = camera;
  wrong.lens = (runmark_lens)5;
  CHECK(runmark_marker_pose(&markers[0], 48, &wrong, NULL, &estimate, &error) == RUNMARK_BAD_ARGUMENT);

  runmark_board* board = NULL;
  file =
      write_text(folder, "board.json",
                 "{\"dictionary\": \"tag36h11\", \"markers\": [{\"id\": 7, \"size\": 48, \"centre\": [69.5, "
                 "49.5, 0]}, {\"id\": 42, \"size\": 64, \"centre\": [239.5, 169.5, 0]}]}");
  CHECK(runmark_board_load(file, &board, &error) == RUNMARK_OK);
  CHECK(runmark_board_pose(board, detector, &frame, &camera, &estimate, &error) == RUNMARK_OK);
  check_identity(estimate.best.rotation);
  CHECK(fabs(estimate.best.translation[0] + 159.5) < 1 && fabs(estimate.best.translation[1] + 119.5) < 1);
  CHECK(fabs(estimate.best.translation[2] - 600) < 3);
  CHECK(runmark_board_pose(board, NULL, &frame, &camera, &estimate, &error) == RUNMARK_BAD_ARGUMENT);
  runmark_board_free(board);
  CHECK(runmark_board_load("grid:tag36h11:2x2:1:1", &board, &error) == RUNMARK_OK);
  CHECK(runmark_board_pose(board, detector, &frame, &camera, &estimate, &error) == RUNMARK_NO_POSE);
  CHECK(strlen(error.message) > 10);
  runmark_board_free(board);
  CHECK(runmark_board_load("circle", &board, &error) == RUNMARK_FAILED && board == NULL);
  runmark_board_free(NULL);
  runmark_detector_free(detector);
}
