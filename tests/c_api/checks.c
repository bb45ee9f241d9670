#include "checks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

void check(int good, const char* what, const char* file, int line) {
  if (good) return;
  ++failures;
  printf("%s:%d: %s\n", file, line, what);
}

int failed_checks(void) { return failures; }

picture read_pgm(const char* path) {
  picture p = {0, 0, NULL};
  FILE* file = fopen(path, "rb");
  if (file == NULL || fscanf(file, "P5 %d %d 255", &p.width, &p.height) != 2 || fgetc(file) == EOF) exit(99);
  const size_t size = (size_t)p.width * (size_t)p.height;
  p.grey = malloc(size);
  if (p.grey == NULL || fread(p.grey, 1, size, file) != size) exit(99);
  fclose(file);
  return p;
}

runmark_options default_options(void) {
  runmark_options options;
  CHECK(runmark_options_init(&options, RUNMARK_ABI_VERSION) == RUNMARK_OK);
  return options;
}

runmark_dictionary* load(const char* name) {
  runmark_dictionary* dictionary = NULL;
  runmark_error error;
  CHECK(runmark_dictionary_load(name, &dictionary, &error) == RUNMARK_OK);
  CHECK(error.status == RUNMARK_OK && error.message[0] == '\0');
  return dictionary;
}

runmark_detector* make(const runmark_options* options, const char* name) {
  runmark_dictionary* dictionary = load(name);
  runmark_detector* detector = NULL;
  CHECK(runmark_detector_create(options, &dictionary, 1, &detector, NULL) == RUNMARK_OK);
  runmark_dictionary_free(dictionary); /* the detector has a copy */
  return detector;
}

size_t all_markers(const runmark_detector* detector, runmark_marker* markers) {
  const size_t count = runmark_marker_count(detector);
  for (size_t i = 0; i < count && i < max_markers; ++i) {
    CHECK(runmark_get_marker(detector, i, &markers[i]) == RUNMARK_OK);
  }
  return count;
}

void check_same(const runmark_marker* a, const runmark_marker* b, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    CHECK(a[i].id == b[i].id);
    CHECK(memcmp(a[i].corners, b[i].corners, sizeof a[i].corners) == 0);
  }
}
