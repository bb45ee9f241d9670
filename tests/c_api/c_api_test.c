/* The C API as a C99 program meets it: c_api_test PICTURE.pgm FOLDER; the picture
 * holds tag36h11 7 and 42.
 * A failed check names its line; the exit status is the number of failed checks. */
#include <math.h>
#include <runmark/runmark.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void check(int good, const char* what, int line) {
  if (good) return;
  ++failures;
  printf("c_api_test.c:%d: %s\n", line, what);
}
#define CHECK(condition) check(condition, #condition, __LINE__)

enum { max_markers = 16 };

typedef struct picture {
  int width;
  int height;
  uint8_t* grey;
} picture;

static picture read_pgm(const char* path) {
  picture p = {0, 0, NULL};
  FILE* file = fopen(path, "rb");
  if (file == NULL || fscanf(file, "P5 %d %d 255", &p.width, &p.height) != 2 || fgetc(file) == EOF) exit(99);
  const size_t size = (size_t)p.width * (size_t)p.height;
  p.grey = malloc(size);
  if (p.grey == NULL || fread(p.grey, 1, size, file) != size) exit(99);
  fclose(file);
  return p;
}

static runmark_options default_options(void) {
  runmark_options options;
  CHECK(runmark_options_init(&options, RUNMARK_ABI_VERSION) == RUNMARK_OK);
  return options;
}

static runmark_dictionary* load(const char* name) {
  runmark_dictionary* dictionary = NULL;
  runmark_error error;
  CHECK(runmark_dictionary_load(name, &dictionary, &error) == RUNMARK_OK);
  CHECK(error.status == RUNMARK_OK && error.message[0] == '\0');
  return dictionary;
}

static runmark_detector* make(const runmark_options* options, const char* name) {
  runmark_dictionary* dictionary = load(name);
  runmark_detector* detector = NULL;
  CHECK(runmark_detector_create(options, &dictionary, 1, &detector, NULL) == RUNMARK_OK);
  runmark_dictionary_free(dictionary); /* the detector has a copy */
  return detector;
}

static size_t all_markers(const runmark_detector* detector, runmark_marker* markers) {
  const size_t count = runmark_marker_count(detector);
  for (size_t i = 0; i < count && i < max_markers; ++i) {
    CHECK(runmark_get_marker(detector, i, &markers[i]) == RUNMARK_OK);
  }
  return count;
}

static void check_same(const runmark_marker* a, const runmark_marker* b, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    CHECK(a[i].id == b[i].id);
    CHECK(memcmp(a[i].corners, b[i].corners, sizeof a[i].corners) == 0);
  }
}

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

static void dictionaries(void) {
  int has_tag36h11 = 0;
  for (size_t i = 0; i < runmark_builtin_count(); ++i) {
    if (strcmp(runmark_builtin_name(i), "tag36h11") == 0) has_tag36h11 = 1;
  }
  CHECK(has_tag36h11);
  CHECK(runmark_builtin_name(runmark_builtin_count()) == NULL);

  runmark_dictionary* dictionary = load("DICT_4X4_50");
  runmark_dictionary_info info;
  CHECK(runmark_get_dictionary_info(dictionary, &info) == RUNMARK_OK);
  CHECK(strcmp(info.name, "DICT_4X4_50") == 0);
  CHECK(info.ids == 50 && info.width == 6 && info.data_cells == 16 && info.distance == 4);
  runmark_dictionary_free(dictionary);

  const char codes[] = "4 0\nb532\n0f9a\n";
  runmark_error error;
  const runmark_status parsed =
      runmark_dictionary_parse(codes, sizeof codes - 1, "mine", &dictionary, &error);
  if (parsed == RUNMARK_OK) {
    CHECK(runmark_get_dictionary_info(dictionary, &info) == RUNMARK_OK);
    CHECK(info.ids == 2 && strcmp(info.name, "mine") == 0);
  } else {
    printf("%s\n", error.message);
    CHECK(0);
  }
  runmark_dictionary_free(dictionary);

  CHECK(runmark_dictionary_load("tag36h12", &dictionary, &error) == RUNMARK_BAD_DICTIONARY);
  CHECK(dictionary == NULL && error.status == RUNMARK_BAD_DICTIONARY);
  CHECK(strstr(error.message, "tag36h11") != NULL); /* the closest name is told */
  CHECK(runmark_dictionary_load("/no/such.codes", &dictionary, &error) == RUNMARK_BAD_DICTIONARY);
  CHECK(strstr(error.message, "/no/such.codes") != NULL);
  CHECK(runmark_dictionary_parse("nonsense", 8, "mine", &dictionary, &error) == RUNMARK_BAD_DICTIONARY);
  CHECK(runmark_dictionary_load("tag36h12", &dictionary, NULL) == RUNMARK_BAD_DICTIONARY);

  char* long_name = malloc(5000);
  if (long_name == NULL) exit(99);
  memset(long_name, 'x', 4999);
  long_name[4999] = '\0';
  CHECK(runmark_dictionary_load(long_name, &dictionary, &error) == RUNMARK_BAD_DICTIONARY);
  CHECK(strlen(error.message) == sizeof error.message - 1); /* cut, and ended */
  free(long_name);
}

static void null_pointers(void) {
  runmark_error error;
  runmark_options options = default_options();
  runmark_dictionary* dictionary = NULL;
  runmark_detector* detector = NULL;
  runmark_marker marker;
  runmark_stats stats;
  runmark_dictionary_info info;
  runmark_image image = runmark_grey_image(NULL, 8, 8, 8);
  CHECK(runmark_options_init(NULL, RUNMARK_ABI_VERSION) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_dictionary_load(NULL, &dictionary, &error) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_dictionary_load("tag36h11", NULL, &error) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_dictionary_parse(NULL, 0, "mine", &dictionary, &error) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_get_dictionary_info(NULL, &info) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_detector_create(NULL, &dictionary, 1, &detector, &error) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_detector_create(&options, NULL, 1, &detector, &error) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_detect(NULL, &image) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_begin(NULL, 8, 8) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_push_rows(NULL, &image) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_end(NULL) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_marker_count(NULL) == 0);
  CHECK(runmark_detector_memory(NULL) == 0);
  CHECK(runmark_get_marker(NULL, 0, &marker) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_get_stats(NULL, &stats) == RUNMARK_BAD_ARGUMENT);
  runmark_dictionary_free(NULL);
  runmark_detector_free(NULL);

  detector = make(&options, "tag36h11");
  CHECK(runmark_detect(detector, NULL) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_detect(detector, &image) == RUNMARK_BAD_VIEW);
  CHECK(runmark_get_marker(detector, 0, &marker) == RUNMARK_BAD_ARGUMENT);
  CHECK(runmark_get_stats(detector, NULL) == RUNMARK_BAD_ARGUMENT);
  runmark_detector_free(detector);
}

static void bad_options(void) {
  runmark_options options;
  CHECK(runmark_options_init(&options, RUNMARK_ABI_VERSION + 1) == RUNMARK_BAD_OPTIONS);

  runmark_error error;
  runmark_detector* detector = NULL;
  runmark_dictionary* dictionary = load("tag36h11");
  memset(&options, 0, sizeof options);
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_BAD_OPTIONS);
  CHECK(strstr(error.message, "runmark_options_init") != NULL);
  options = default_options();
  options.max_width = 0;
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_BAD_OPTIONS);
  CHECK(strstr(error.message, "max_width") != NULL);
  options = default_options();
  options.pipeline = (runmark_pipeline)7;
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_BAD_OPTIONS);
  CHECK(strstr(error.message, "pipeline 7") != NULL);
  options = default_options();
  options.filter = 1000;
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_BAD_OPTIONS);
  CHECK(strstr(error.message, "filter 1000") != NULL);
  options = default_options();
  CHECK(runmark_detector_create(&options, &dictionary, 0, &detector, &error) == RUNMARK_BAD_OPTIONS);
  CHECK(strstr(error.message, "no dictionary") != NULL);
  CHECK(detector == NULL);
  runmark_dictionary_free(dictionary);

  dictionary = load("tagStandard41h12");
  options.pipeline = RUNMARK_PIPELINE_PAPER;
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_BAD_OPTIONS);
  CHECK(strstr(error.message, "tagStandard41h12") != NULL);
  runmark_dictionary_free(dictionary);
}

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

static void streaming(const picture* p) {
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
static void poses(const picture* p, const char* folder) {
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

/* Run where the memory is limited: no exception leaves the library, the error says what is wrong. */
static void out_of_memory(void) {
  runmark_options options = default_options();
  options.max_width = 65535;
  options.max_height = 65535;
  options.copy_rows = 1;
  runmark_dictionary* dictionary = load("tag36h11");
  runmark_detector* detector = NULL;
  runmark_error error;
  CHECK(runmark_detector_create(&options, &dictionary, 1, &detector, &error) == RUNMARK_OUT_OF_MEMORY);
  CHECK(detector == NULL && strcmp(error.message, "out of memory") == 0);
  runmark_dictionary_free(dictionary);
}

int main(int argc, char** argv) {
  if (argc == 2 && strcmp(argv[1], "--out-of-memory") == 0) {
    out_of_memory();
    return failures;
  }
  if (argc != 3) return 99;
  picture p = read_pgm(argv[1]);
  versions();
  layout_of_version_1();
  dictionaries();
  null_pointers();
  bad_options();
  whole_frames(&p);
  several_dictionaries(&p);
  streaming(&p);
  rejected_squares(&p);
  poses(&p, argv[2]);
  free(p.grey);
  printf("%d checks failed\n", failures);
  return failures;
}
