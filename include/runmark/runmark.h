/* runmark from C99 and from every language that can call C: link librunmark_c (pkg-config runmark_c, or
 * CMake's runmark::c).
 *
 * - A call that can fail returns a runmark_status. Calls that read names, files or options also take a
 *   runmark_error, which may be NULL, and put a line for a person into it.
 * - Handles are opaque: what `..._load`, `..._parse` or `..._create` gave goes to the `..._free` of its type.
 *   A null handle is refused with RUNMARK_BAD_ARGUMENT, and freeing one does nothing.
 * - No C++ exception leaves the library, and it never prints or aborts.
 * - Handles of one detector, one thread at a time; different detectors do not touch each other.
 *
 * Pixels: the centre of the top-left pixel is (0, 0), x goes right and y down. */
#ifndef RUNMARK_RUNMARK_H
#define RUNMARK_RUNMARK_H

#include <stddef.h>
#include <stdint.h>

#include "runmark/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The layout of all types and the meaning of all functions below. Within one number the library only gains
 * functions. It is part of the shared library's name, and a program that loads the library by hand compares
 * it with runmark_abi_version. */
#define RUNMARK_ABI_VERSION 1

RUNMARK_EXPORT uint32_t runmark_abi_version(void);
/* As "0.1.0". */
RUNMARK_EXPORT const char* runmark_version(void);

/* ---- Errors ---------------------------------------------------------------------------------------- */

typedef enum runmark_status {
  RUNMARK_OK = 0,
  RUNMARK_BAD_ARGUMENT = 1,    /* a null pointer, an index or a value out of its range */
  RUNMARK_BAD_VIEW = 2,        /* the fields of a runmark_image contradict each other */
  RUNMARK_FRAME_TOO_LARGE = 3, /* wider or higher than max_width or max_height */
  RUNMARK_WRONG_ORDER = 4,     /* a streaming call that does not follow the one before it */
  RUNMARK_BAD_DICTIONARY = 5,  /* no such dictionary, or one that cannot be read or used */
  RUNMARK_BAD_OPTIONS = 6,     /* an option out of its range, or options of another ABI version */
  RUNMARK_OUT_OF_MEMORY = 7,
  RUNMARK_NO_POSE = 8,     /* no pose explains the corners, or too little of a board is seen */
  RUNMARK_UNAVAILABLE = 9, /* the library was built without poses, which need OpenCV */
  RUNMARK_FAILED = 10      /* none of the above; the message says what */
} runmark_status;

/* One line for a person, for any status; static storage. */
RUNMARK_EXPORT const char* runmark_describe(runmark_status status);

/* What is wrong and where, in one line; longer lines are cut. */
typedef struct runmark_error {
  runmark_status status;
  char message[508];
} runmark_error;

/* ---- Dictionaries ---------------------------------------------------------------------------------- */

typedef struct runmark_dictionary runmark_dictionary;

/* The names of the built-in dictionaries, sorted; NULL from runmark_builtin_count() on. */
RUNMARK_EXPORT size_t runmark_builtin_count(void);
RUNMARK_EXPORT const char* runmark_builtin_name(size_t index);

/* A built-in dictionary by its name (DICT_4X4_50, tag36h11), or a .codes file by its path. */
RUNMARK_EXPORT runmark_status runmark_dictionary_load(const char* name_or_path,
                                                      runmark_dictionary** dictionary, runmark_error* error);
/* A dictionary from the text of a .codes file, which docs/dictionaries.md describes. */
RUNMARK_EXPORT runmark_status runmark_dictionary_parse(const char* text, size_t size, const char* name,
                                                       runmark_dictionary** dictionary, runmark_error* error);
RUNMARK_EXPORT void runmark_dictionary_free(runmark_dictionary* dictionary);

typedef struct runmark_dictionary_info {
  const char* name;       /* valid as long as the dictionary */
  int32_t ids;            /* they run from 0 to ids - 1 */
  int32_t width;          /* cells along the side of the detected square, border included */
  int32_t data_cells;     /* bits of a code */
  int32_t corrected_bits; /* wrong bits that may be corrected: safe by default */
  int32_t distance;       /* the least Hamming distance of two codes in any rotation */
} runmark_dictionary_info;

RUNMARK_EXPORT runmark_status runmark_get_dictionary_info(const runmark_dictionary* dictionary,
                                                          runmark_dictionary_info* info);

/* ---- Options --------------------------------------------------------------------------------------- */

typedef enum runmark_pipeline {
  RUNMARK_PIPELINE_PAPER = 0,    /* the published system */
  RUNMARK_PIPELINE_HARDWARE = 1, /* what the FPGA core computes, in integers only */
  RUNMARK_PIPELINE_DEFAULT = 2   /* the best software */
} runmark_pipeline;

typedef enum runmark_connectivity {
  RUNMARK_CONNECTIVITY_DEFAULT = 0, /* the pipeline's own: eight in the paper's, four in the others */
  RUNMARK_CONNECTIVITY_FOUR = 1,
  RUNMARK_CONNECTIVITY_EIGHT = 2
} runmark_connectivity;

/* Cases of the paper's Fig. 2 are the bits 1, 2, 4, 8, 16, 32 for (a) to (f); this is the pipeline's own. */
#define RUNMARK_FILTER_DEFAULT 255

/* Tunables of a detector. runmark_options_init gives the defaults, which suit most pictures;
 * runmark/options.h says of each when to change it. */
typedef struct runmark_options {
  uint32_t abi_version; /* set by runmark_options_init */
  runmark_pipeline pipeline;
  int32_t max_width; /* the largest frame, pixels: memory is set aside for it once */
  int32_t max_height;
  int32_t region[4];      /* x, y, width, height in pixels; width and height 0: the whole frame */
  double min_marker_size; /* side of the black square, pixels */
  double max_marker_size;
  int32_t inverted;       /* 1: look for white-on-black markers too */
  int32_t corrected_bits; /* -1: each dictionary's own safe number */
  float min_margin;       /* 0 to 0.5 */
  int32_t min_contrast;   /* grey levels */
  int32_t octaves;        /* how often the rows are halved to find large and blurred markers */
  int32_t copy_rows;      /* 1: rows given to runmark_push_rows need not outlive the call */
  int32_t keep_rejected;  /* 1: keep the squares that turned out to be no marker */
  int32_t filter;         /* bits, or RUNMARK_FILTER_DEFAULT */
  runmark_connectivity connectivity;
  int32_t fixed_threshold; /* paper pipeline: grey levels below it are dark */
  int32_t above_is_dark;   /* paper pipeline: 1: levels at or above it are dark instead */
  int32_t corner_offset;   /* paper pipeline: pixels */
} runmark_options;

/* Pass RUNMARK_ABI_VERSION. A library of another version touches nothing and returns RUNMARK_BAD_OPTIONS. */
RUNMARK_EXPORT runmark_status runmark_options_init(runmark_options* options, uint32_t abi_version);

/* ---- Images ---------------------------------------------------------------------------------------- */

typedef enum runmark_format {
  RUNMARK_GREY = 0, /* one byte a pixel */
  RUNMARK_RGB = 1,  /* three bytes a pixel, red first */
  RUNMARK_BGR = 2   /* three bytes a pixel, blue first */
} runmark_format;

/* Pixels in the caller's memory. */
typedef struct runmark_image {
  const uint8_t* data; /* first byte of the top-left pixel */
  int32_t width;       /* pixels, at most 65535 */
  int32_t height;
  ptrdiff_t stride; /* bytes from one row to the next; negative for a picture stored upside down */
  int32_t step;     /* bytes from one pixel to the next; may be negative */
  runmark_format format;
} runmark_image;

static inline runmark_image runmark_grey_image(const uint8_t* data, int32_t width, int32_t height,
                                               ptrdiff_t stride) {
  runmark_image image = {data, width, height, stride, 1, RUNMARK_GREY};
  return image;
}

static inline runmark_image runmark_bgr_image(const uint8_t* data, int32_t width, int32_t height,
                                              ptrdiff_t stride) {
  runmark_image image = {data, width, height, stride, 3, RUNMARK_BGR};
  return image;
}

static inline runmark_image runmark_rgb_image(const uint8_t* data, int32_t width, int32_t height,
                                              ptrdiff_t stride) {
  runmark_image image = {data, width, height, stride, 3, RUNMARK_RGB};
  return image;
}

/* ---- Detection ------------------------------------------------------------------------------------- */

typedef struct runmark_detector runmark_detector;

/* Makes a detector that looks for the markers of all `count` dictionaries. It keeps copies of them. All
 * memory is allocated here. */
RUNMARK_EXPORT runmark_status runmark_detector_create(const runmark_options* options,
                                                      runmark_dictionary* const* dictionaries, size_t count,
                                                      runmark_detector** detector, runmark_error* error);
RUNMARK_EXPORT void runmark_detector_free(runmark_detector* detector);
/* Bytes it holds. */
RUNMARK_EXPORT size_t runmark_detector_memory(const runmark_detector* detector);

/* Finds the markers of a whole frame. */
RUNMARK_EXPORT runmark_status runmark_detect(runmark_detector* detector, const runmark_image* frame);

/* Row streaming: begin, any number of push_rows from top to bottom, end. Markers can be read as soon as
 * their last row and a few below it are in; none is ever taken back. The rows' memory must stay valid until
 * runmark_end, unless the option copy_rows is set. Before all rows are in, runmark_end gives up the rest of
 * the frame and returns RUNMARK_WRONG_ORDER. */
RUNMARK_EXPORT runmark_status runmark_begin(runmark_detector* detector, int32_t width, int32_t height);
RUNMARK_EXPORT runmark_status runmark_push_rows(runmark_detector* detector, const runmark_image* rows);
RUNMARK_EXPORT runmark_status runmark_end(runmark_detector* detector);

typedef struct runmark_marker {
  const char* dictionary; /* its name; valid as long as the detector */
  int32_t id;
  int32_t hamming; /* bits that were corrected */
  /* x, y in pixels: top-left, top-right, bottom-right, bottom-left of the marker as it is drawn */
  double corners[4][2];
  float margin;     /* from 0 (doubtful) to 0.5 (clear) */
  int32_t inverted; /* 1: white on black */
  int32_t row;      /* the frame row that had come in when the marker was given out */
} runmark_marker;

/* Of the last frame, or of the rows pushed so far. */
RUNMARK_EXPORT size_t runmark_marker_count(const runmark_detector* detector);
RUNMARK_EXPORT runmark_status runmark_get_marker(const runmark_detector* detector, size_t index,
                                                 runmark_marker* marker);

/* The squares in which no marker was read: x, y of their corners in pixels, clockwise. None without the
 * option keep_rejected; complete when the frame is. */
RUNMARK_EXPORT size_t runmark_rejected_count(const runmark_detector* detector);
RUNMARK_EXPORT runmark_status runmark_get_rejected(const runmark_detector* detector, size_t index,
                                                   double corners[4][2]);

/* Counts of one frame: the work that was done, and what a full capacity made the detector drop. */
typedef struct runmark_stats {
  uint64_t pixels;
  uint64_t crack_runs;
  uint64_t closed_chains;
  uint64_t quads;
  uint64_t records_peak;
  uint64_t dropped_chains;
  uint64_t dropped_markers;
} runmark_stats;

RUNMARK_EXPORT runmark_status runmark_get_stats(const runmark_detector* detector, runmark_stats* stats);

/* ---- Poses: RUNMARK_UNAVAILABLE in a library that was built without OpenCV ------------------------- */

typedef enum runmark_lens {
  RUNMARK_LENS_PLAIN = 0,    /* k1 k2 p1 p2 k3 */
  RUNMARK_LENS_RATIONAL = 1, /* k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 */
  RUNMARK_LENS_FISHEYE = 2   /* k1 k2 k3 k4 */
} runmark_lens;

/* A calibrated camera, as OpenCV and ROS describe it. Its frame: x right, y down, z forwards. */
typedef struct runmark_camera {
  int32_t width; /* of the pictures it was calibrated with; 0 when not known */
  int32_t height;
  double fx; /* focal lengths, pixels */
  double fy;
  double cx; /* where the optical axis meets the picture, pixels */
  double cy;
  runmark_lens lens;
  double distortion[12]; /* in the order above, then 0 */
} runmark_camera;

/* Reads a camera file of OpenCV or of ROS (YAML). */
RUNMARK_EXPORT runmark_status runmark_camera_load(const char* path, runmark_camera* camera,
                                                  runmark_error* error);

/* Takes points of an object's frame to the camera's. A marker's frame has its origin in the marker's middle,
 * x along its upper side to the right, y down, z into the sheet. */
typedef struct runmark_pose {
  double rotation[9];    /* row-major */
  double translation[3]; /* in the unit of the marker's size */
  double error;          /* rms distance of the projected corners from those seen, pixels */
  /* 6x6, row-major: the translation's x, y, z, then the rotation about the camera's x, y, z axes in radians
   */
  double covariance[36];
} runmark_pose;

/* The corners of something flat often allow two poses that explain them almost alike. */
typedef struct runmark_pose_estimate {
  runmark_pose best;
  runmark_pose other;
  int32_t has_other;
  double ambiguity; /* near 0: best is right; near 1: either may be */
} runmark_pose_estimate;

/* The pose of a marker whose side is `size` long. `image` is the frame it was found in and says how sure its
 * corners are; it may be NULL. */
RUNMARK_EXPORT runmark_status runmark_marker_pose(const runmark_marker* marker, double size,
                                                  const runmark_camera* camera, const runmark_image* image,
                                                  runmark_pose_estimate* estimate, runmark_error* error);

/* Markers whose places are known relative to each other. */
typedef struct runmark_board runmark_board;

/* charuco:DICTIONARY:COLUMNSxROWS:SQUARE:MARKER[:legacy][:turned], grid:DICTIONARY:COLUMNSxROWS:MARKER:GAP,
 * or the path of a .json file; docs/boards.md describes them. */
RUNMARK_EXPORT runmark_status runmark_board_load(const char* description_or_path, runmark_board** board,
                                                 runmark_error* error);
RUNMARK_EXPORT void runmark_board_free(runmark_board* board);

/* The pose of a board from the markers of the detector's last frame, which is `image`. */
RUNMARK_EXPORT runmark_status runmark_board_pose(const runmark_board* board, const runmark_detector* detector,
                                                 const runmark_image* image, const runmark_camera* camera,
                                                 runmark_pose_estimate* estimate, runmark_error* error);

#ifdef __cplusplus
}
#endif

#endif
