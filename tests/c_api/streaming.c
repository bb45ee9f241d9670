#include "checks.h"

#include <stdlib.h>
#include <string.h>

void test_streaming(const picture* p) {
  runmark_options options = default_options();
  options.copy_rows = 1;
  runmark_detector* detector = make(&options, "tag36h11");
  const runmark_image frame = runmark_grey_image(p->grey, p->width, p->height, p->width);
  runmark_marker whole[max_markers];
  runmark_marker streamed[max_markers];
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);
  const size_t count = all_markers(detector, whole);

  uint8_t* row = malloc((size_t)p->width); /* one row's memory for all of them: copy_rows */
  if (row == NULL) exit(99);
  int first_at = -1;
  CHECK(runmark_begin(detector, p->width, p->height) == RUNMARK_OK);
  CHECK(runmark_begin(detector, p->width, p->height) == RUNMARK_WRONG_ORDER);
  for (int y = 0; y < p->height; ++y) {
    memcpy(row, p->grey + (size_t)y * (size_t)p->width, (size_t)p->width);
    const runmark_image one = runmark_grey_image(row, p->width, 1, p->width);
    CHECK(runmark_push_rows(detector, &one) == RUNMARK_OK);
    if (first_at < 0 && runmark_marker_count(detector) > 0) first_at = y;
  }
  const runmark_image too_many = runmark_grey_image(row, p->width, 1, p->width);
  CHECK(runmark_push_rows(detector, &too_many) == RUNMARK_WRONG_ORDER);
  CHECK(runmark_end(detector) == RUNMARK_OK);
  CHECK(runmark_end(detector) == RUNMARK_WRONG_ORDER);
  CHECK(all_markers(detector, streamed) == count);
  check_same(whole, streamed, count);
  CHECK(first_at == streamed[0].row && first_at < p->height / 2); /* known long before the last row */

  CHECK(runmark_begin(detector, p->width, p->height) == RUNMARK_OK);
  CHECK(runmark_end(detector) == RUNMARK_WRONG_ORDER); /* rows are missing; the next frame is as new */
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);
  CHECK(all_markers(detector, streamed) == count);
  free(row);
  runmark_detector_free(detector);
}
