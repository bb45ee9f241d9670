#include "checks.h"

#include <string.h>

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

void test_misuse(void) {
  null_pointers();
  bad_options();
}

/* Run where the memory is limited: no exception leaves the library, the error says what is wrong. */
void test_out_of_memory(void) {
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
