/* The C API as a C99 program meets it: c_api_test PICTURE.pgm FOLDER; the picture holds tag36h11 7 and 42.
 * The exit status is the number of failed checks. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "checks.h"

static void versions(void) {
  CHECK(runmark_abi_version() == RUNMARK_ABI_VERSION);
  CHECK(strchr(runmark_version(), '.') != NULL);
  for (int status = RUNMARK_OK; status <= RUNMARK_FAILED + 1; ++status) {
    CHECK(strlen(runmark_describe((runmark_status)status)) > 1);
  }
}

/* A change here breaks compiled programs: it needs another RUNMARK_ABI_VERSION. */
static void layout_of_version_1(void) {
  if (sizeof(void*) != 8) return;
  CHECK(RUNMARK_ABI_VERSION == 1);
  CHECK(sizeof(runmark_status) == 4 && sizeof(runmark_format) == 4);
  CHECK(sizeof(runmark_error) == 512 && offsetof(runmark_error, message) == 4);
  CHECK(sizeof(runmark_dictionary_info) == 32 && offsetof(runmark_dictionary_info, distance) == 24);
  CHECK(sizeof(runmark_options) == 96 && offsetof(runmark_options, min_marker_size) == 32);
  CHECK(offsetof(runmark_options, connectivity) == 80);
  CHECK(sizeof(runmark_image) == 32 && offsetof(runmark_image, stride) == 16);
  CHECK(sizeof(runmark_marker) == 96 && offsetof(runmark_marker, corners) == 16);
  CHECK(offsetof(runmark_marker, row) == 88);
  CHECK(sizeof(runmark_stats) == 56 && offsetof(runmark_stats, dropped_markers) == 48);
  CHECK(sizeof(runmark_camera) == 144 && offsetof(runmark_camera, distortion) == 48);
  CHECK(sizeof(runmark_pose) == 392 && offsetof(runmark_pose, covariance) == 104);
  CHECK(sizeof(runmark_pose_estimate) == 800 && offsetof(runmark_pose_estimate, ambiguity) == 792);
}

int main(int argc, char** argv) {
  if (argc == 2 && strcmp(argv[1], "--out-of-memory") == 0) {
    test_out_of_memory();
    return failed_checks();
  }
  if (argc != 3) return 99;
  picture p = read_pgm(argv[1]);
  versions();
  layout_of_version_1();
  test_dictionaries();
  test_misuse();
  test_detection(&p);
  test_streaming(&p);
  test_poses(&p, argv[2]);
  free(p.grey);
  printf("%d checks failed\n", failed_checks());
  return failed_checks();
}
