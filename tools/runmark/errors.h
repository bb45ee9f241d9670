#pragma once

#include <stdexcept>
#include <string_view>
#include <utility>

#include "runmark/result.h"

namespace runmark::cli {

/// Exit statuses besides 0.
inline constexpr int exit_failure = 2;        ///< something was wrong and was said on stderr
inline constexpr int exit_interrupted = 130;  ///< Ctrl-C, after the work in hand was finished

/// What is wrong and where, in one line. main prints it and ends the program with exit_failure.
class UserError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One input is broken; the others can still be worked through.
class InputError : public UserError {
  using UserError::UserError;
};

/// Ends the program with this status after everything has been said.
struct ExitStatus {
  int value = 0;
};

/// Prints one line, `<program>: <message>`, on stderr; line breaks in the message become "; ".
void print_error(std::string_view message, std::string_view program = "runmark");

/// The result's value, or its error as a UserError that starts with `where` ("frame.png").
template <class T>
[[nodiscard]] T value_or_throw(Result<T> result, std::string_view where = {}) {
  if (result) return *std::move(result);
  throw UserError(where.empty() ? result.error() : std::string(where) + ": " + result.error());
}

}  // namespace runmark::cli
