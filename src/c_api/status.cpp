#include "runmark/version.h"

#include <cstdint>

#include "c_api/number.h"
#include "runmark/runmark.h"

std::uint32_t runmark_abi_version() { return RUNMARK_ABI_VERSION; }

const char* runmark_version() { return RUNMARK_VERSION; }

const char* runmark_describe(runmark_status status) {
  switch (runmark::c_api::number(status)) {
    case RUNMARK_OK:
      return "ok";
    case RUNMARK_BAD_ARGUMENT:
      return "a null pointer, or an index or value out of its range";
    case RUNMARK_BAD_VIEW:
      return "the image's data, size, stride and step contradict each other";
    case RUNMARK_FRAME_TOO_LARGE:
      return "the frame is larger than the detector's max_width x max_height";
    case RUNMARK_WRONG_ORDER:
      return "this streaming call does not follow the one before it";
    case RUNMARK_BAD_DICTIONARY:
      return "no such dictionary, or one that cannot be used";
    case RUNMARK_BAD_OPTIONS:
      return "an option is out of its range, or the options are of another ABI version";
    case RUNMARK_OUT_OF_MEMORY:
      return "out of memory";
    case RUNMARK_NO_POSE:
      return "no pose explains the corners, or too little of the board is seen";
    case RUNMARK_UNAVAILABLE:
      return "this library was built without poses";
    case RUNMARK_FAILED:
      break;
  }
  return "failed";
}
