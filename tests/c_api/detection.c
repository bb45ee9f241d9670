#include "checks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void whole_frames(const picture* p) {
  runmark_options options = default_options();
  options.max_width = p->width;
  options.max_height = p->height;
  runmark_detector* detector = make(&options, "tag36h11");
  CHECK(runmark_detector_memory(detector) > 10000);
  const runmark_image frame = runmark_grey_image(p->grey, p->width, p->height, p->width);
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);

  runmark_marker markers[max_markers];
  const size_t count = all_markers(detector, markers);
  CHECK(count == 2);
  CHECK(markers[0].id == 7 && markers[1].id == 42);
  for (size_t i = 0; i < count; ++i) {
    CHECK(strcmp(markers[i].dictionary, "tag36h11") == 0);
    CHECK(markers[i].hamming == 0 && markers[i].inverted == 0 && markers[i].margin > 0.2F);
    /* upright, so the corners go clockwise from the top-left one */
    CHECK(markers[i].corners[0][0] < markers[i].corners[1][0]);
    CHECK(markers[i].corners[1][1] < markers[i].corners[2][1]);
    CHECK(fabs(markers[i].corners[0][0] - markers[i].corners[3][0]) < 0.1);
    CHECK(markers[i].row > markers[i].corners[2][1] - 1 && markers[i].row < p->height);
  }
  runmark_stats stats;
  CHECK(runmark_get_stats(detector, &stats) == RUNMARK_OK);
  CHECK(stats.pixels >= (uint64_t)p->width * (uint64_t)p->height);
  CHECK(stats.quads >= 2 && stats.dropped_chains == 0);

  /* The same picture in colour, and stored upside down. */
  const size_t size = (size_t)p->width * (size_t)p->height;
  uint8_t* other = malloc(3 * size);
  runmark_marker again[max_markers];
  if (other == NULL) exit(99);
  for (size_t i = 0; i < 3 * size; ++i) other[i] = p->grey[i / 3];
  const runmark_image bgr = runmark_bgr_image(other, p->width, p->height, 3 * (ptrdiff_t)p->width);
  CHECK(runmark_detect(detector, &bgr) == RUNMARK_OK && all_markers(detector, again) == count);
  check_same(markers, again, count);
  const runmark_image rgb = runmark_rgb_image(other, p->width, p->height, 3 * (ptrdiff_t)p->width);
  CHECK(runmark_detect(detector, &rgb) == RUNMARK_OK && all_markers(detector, again) == count);
  for (int y = 0; y < p->height; ++y) {
    memcpy(other + (size_t)(p->height - 1 - y) * (size_t)p->width, p->grey + (size_t)y * (size_t)p->width,
           (size_t)p->width);
  }
  const runmark_image flipped =
      runmark_grey_image(other + size - (size_t)p->width, p->width, p->height, -(ptrdiff_t)p->width);
  CHECK(runmark_detect(detector, &flipped) == RUNMARK_OK && all_markers(detector, again) == count);
  check_same(markers, again, count);
  free(other);

  runmark_image wrong = frame;
  wrong.format = (runmark_format)9;
  CHECK(runmark_detect(detector, &wrong) == RUNMARK_BAD_VIEW);
  wrong = frame;
  wrong.stride = p->width / 2;
  CHECK(runmark_detect(detector, &wrong) == RUNMARK_BAD_VIEW);
  wrong = frame;
  wrong.width = p->width + 1;
  wrong.stride = p->width + 1;
  wrong.height = 2;
  CHECK(runmark_detect(detector, &wrong) == RUNMARK_FRAME_TOO_LARGE);
  runmark_detector_free(detector);
}

static void several_dictionaries(const picture* p) {
  const runmark_options options = default_options();
  runmark_dictionary* both[2];
  both[0] = load("DICT_4X4_50");
  both[1] = load("tag36h11");
  runmark_detector* detector = NULL;
  CHECK(runmark_detector_create(&options, both, 2, &detector, NULL) == RUNMARK_OK);
  const runmark_image frame = runmark_grey_image(p->grey, p->width, p->height, p->width);
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);
  runmark_marker markers[max_markers];
  CHECK(all_markers(detector, markers) == 2);
  CHECK(strcmp(markers[0].dictionary, "tag36h11") == 0);
  runmark_detector_free(detector);
  runmark_dictionary_free(both[0]);
  runmark_dictionary_free(both[1]);
}

static void rejected_squares(const picture* p) {
  runmark_options options = default_options();
  runmark_detector* detector = make(&options, "DICT_4X4_50"); /* knows none of the markers */
  const runmark_image frame = runmark_grey_image(p->grey, p->width, p->height, p->width);
  double corners[4][2];
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);
  CHECK(runmark_marker_count(detector) == 0 && runmark_rejected_count(detector) == 0);
  runmark_detector_free(detector);

  options.keep_rejected = 1;
  detector = make(&options, "DICT_4X4_50");
  CHECK(runmark_detect(detector, &frame) == RUNMARK_OK);
  const size_t count = runmark_rejected_count(detector);
  CHECK(count >= 2);
  int seen = 0;
  for (size_t i = 0; i < count; ++i) {
    CHECK(runmark_get_rejected(detector, i, corners) == RUNMARK_OK);
    if (fabs(corners[0][0] + corners[2][0] - 2 * 69.5) < 1 &&
        fabs(corners[0][1] + corners[2][1] - 2 * 49.5) < 1)
      seen = 1;
  }
  CHECK(seen); /* the square of marker 7, about its middle */
  CHECK(runmark_get_rejected(detector, count, corners) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_get_rejected(detector, 0, NULL) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_rejected_count(NULL) == 0);
  runmark_detector_free(detector);
}

void test_detection(const picture* p) {
  whole_frames(p);
  several_dictionaries(p);
  rejected_squares(p);
}
