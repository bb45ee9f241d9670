/* Finds the markers of one picture, in C: detect PICTURE.pgm */
#include <runmark/runmark.h>
#include <stdio.h>
#include <stdlib.h>

/* README.md shows the lines between the marks; a test compares them. */
/* [readme] */
static int print_markers(const uint8_t* grey, int width, int height) {
  const runmark_image frame = runmark_grey_image(grey, width, height, width);
  runmark_dictionary* dictionary = NULL;
  runmark_detector* detector = NULL;
  runmark_error error = {RUNMARK_OK, ""};
  runmark_options options;
  runmark_options_init(&options, RUNMARK_ABI_VERSION);
  options.max_width = width;
  options.max_height = height;

  runmark_status status = runmark_dictionary_load("tag36h11", &dictionary, &error);
  if (status == RUNMARK_OK) status = runmark_detector_create(&options, &dictionary, 1, &detector, &error);
  if (status == RUNMARK_OK) status = runmark_detect(detector, &frame);
  runmark_marker marker;
  for (size_t i = 0; runmark_get_marker(detector, i, &marker) == RUNMARK_OK; ++i) {
    printf("%s %d: top-left corner %g, %g\n", marker.dictionary, (int)marker.id, marker.corners[0][0],
           marker.corners[0][1]);
  }
  if (status != RUNMARK_OK) fprintf(stderr, "%s %s\n", runmark_describe(status), error.message);

  runmark_detector_free(detector);
  runmark_dictionary_free(dictionary);
  return status == RUNMARK_OK;
}
/* [readme] */

/* The least reader of binary 8-bit PGM files, so that the example needs no image library. */
static uint8_t* read_pgm(const char* path, int* width, int* height) {
  FILE* file = fopen(path, "rb");
  uint8_t* grey = NULL;
  if (file != NULL && fscanf(file, "P5 %d %d 255", width, height) == 2 && *width > 0 && *width < 65536 &&
      *height > 0 && *height < 65536 && fgetc(file) != EOF) {
    const size_t size = (size_t)*width * (size_t)*height;
    grey = malloc(size);
    if (grey != NULL && fread(grey, 1, size, file) != size) {
      free(grey);
      grey = NULL;
    }
  }
  if (file != NULL) fclose(file);
  return grey;
}

int main(int argc, char** argv) {
  int width = 0;
  int height = 0;
  uint8_t* grey = argc == 2 ? read_pgm(argv[1], &width, &height) : NULL;
  int ok = 0;
  if (argc != 2) {
    fprintf(stderr, "usage: detect PICTURE.pgm\n");
  } else if (grey == NULL) {
    fprintf(stderr, "%s: not a whole binary 8-bit PGM\n", argv[1]);
  } else {
    ok = print_markers(grey, width, height);
  }
  free(grey);
  return ok ? 0 : 2;
}
