#pragma once

#include <cstring>
#include <type_traits>

namespace runmark::c_api {

/// What a C caller wrote into an enumeration, which may be any number: C++ may not even read one that it does
/// not have.
template <class Enum>
[[nodiscard]] inline unsigned number(const Enum& value) noexcept {
  static_assert(std::is_enum_v<Enum> && sizeof(Enum) == sizeof(unsigned));
  unsigned result = 0;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

}  // namespace runmark::c_api
