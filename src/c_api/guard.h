#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

#include "runmark/runmark.h"

namespace runmark::c_api {

/// Fills `error` where there is one. Gives `status` back.
inline runmark_status fail(runmark_error* error, runmark_status status, std::string_view message) noexcept {
  if (error != nullptr) {
    error->status = status;
    const std::size_t size = std::min(message.size(), sizeof error->message - 1);
    std::memcpy(error->message, message.data(), size);
    error->message[size] = '\0';
  }
  return status;
}

inline runmark_status fail(runmark_error* error, runmark_status status) noexcept {
  return fail(error, status, runmark_describe(status));
}

/// Runs `work`, which returns a status; what it throws becomes one. Success empties `error`.
template <class Work>
runmark_status guarded(runmark_error* error, const Work& work) noexcept {
  try {
    const runmark_status status = work();
    return status == RUNMARK_OK ? fail(error, RUNMARK_OK, "") : status;
  } catch (const std::bad_alloc&) {
    return fail(error, RUNMARK_OUT_OF_MEMORY);
  } catch (const std::exception& failure) {
    return fail(error, RUNMARK_FAILED, failure.what());
  } catch (...) {
    return fail(error, RUNMARK_FAILED);
  }
}

}  // namespace runmark::c_api
