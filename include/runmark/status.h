#pragma once

#include <cstdint>
#include <string_view>

#include "runmark/export.h"

namespace runmark {

/// What became of a call that cannot allocate, and so cannot carry a message of its own.
enum class Status : std::uint8_t {
  ok,
  bad_view,         ///< the view's fields contradict each other
  frame_too_large,  ///< wider or higher than Options::max_width or max_height
  wrong_order,      ///< a streaming call that does not follow the one before it
};

/// One line for a person.
[[nodiscard]] RUNMARK_EXPORT std::string_view describe(Status status);

}  // namespace runmark
