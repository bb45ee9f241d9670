#include "checks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void test_dictionaries(void) {
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
