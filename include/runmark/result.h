#pragma once

#include <string>
#include <utility>
#include <variant>

namespace runmark {

/// Says what is wrong and where, in one line without a full stop.
struct Error {
  std::string message;
};

/// A value, or the error that stands in its place. Nothing in runmark throws.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : content_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] explicit operator bool() const { return content_.index() == 0; }
  /// Only when the result holds a value.
  [[nodiscard]] T& value() & { return *std::get_if<0>(&content_); }
  [[nodiscard]] const T& value() const& { return *std::get_if<0>(&content_); }
  [[nodiscard]] T&& value() && { return std::move(*std::get_if<0>(&content_)); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T&& operator*() && { return std::move(*this).value(); }
  [[nodiscard]] T* operator->() { return &value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }
  /// Only when the result holds an error.
  [[nodiscard]] const std::string& error() const { return std::get_if<1>(&content_)->message; }

 private:
  std::variant<T, Error> content_;
};

}  // namespace runmark
