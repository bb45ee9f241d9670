/* What the tests of the C API have in common: a C99 program, like those of its users. */
#ifndef RUNMARK_C_API_CHECKS_H
#define RUNMARK_C_API_CHECKS_H

#include <runmark/runmark.h>

/* A failed check names its place. */
void check(int good, const char* what, const char* file, int line);
#define CHECK(condition) check(condition, #condition, __FILE__, __LINE__)
int failed_checks(void);

typedef struct picture {
  int width;
  int height;
  uint8_t* grey;
} picture;

enum { max_markers = 16 };

picture read_pgm(const char* path);
runmark_options default_options(void);
runmark_dictionary* load(const char* name);
/* A detector of one dictionary. */
runmark_detector* make(const runmark_options* options, const char* name);
/* Fills at most max_markers; gives the number of all. */
size_t all_markers(const runmark_detector* detector, runmark_marker* markers);
void check_same(const runmark_marker* a, const runmark_marker* b, size_t count);

/* The tests, a file each. */
void test_dictionaries(void);
void test_misuse(void);
void test_out_of_memory(void);
void test_detection(const picture* p);
void test_streaming(const picture* p);
void test_poses(const picture* p, const char* folder);

#endif
