#include "runmark/status.h"

namespace runmark {

std::string_view describe(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::bad_view:
      return "the image view's fields contradict each other";
    case Status::frame_too_large:
      return "the frame is larger than the detector was made for";
    case Status::wrong_order:
      return "streaming call out of order: begin, push_rows for every row, end";
  }
  return "unknown status";
}

}  // namespace runmark
