#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "evaluate/corners.h"

namespace runmark {

/// Thrown inside the JSON readers of this folder and caught there; never leaves them.
struct FieldError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The member of that name, or a FieldError.
[[nodiscard]] inline const nlohmann::json& member(const nlohmann::json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  if (!object.is_object() || found == object.end()) throw FieldError(std::string("no \"") + name + '"');
  return *found;
}

[[nodiscard]] inline const nlohmann::json& list_member(const nlohmann::json& object, const char* name) {
  const nlohmann::json& list = member(object, name);
  if (!list.is_array()) throw FieldError(std::string("\"") + name + "\" is not a list");
  return list;
}

[[nodiscard]] inline std::string text_member(const nlohmann::json& object, const char* name) {
  const nlohmann::json& value = member(object, name);
  if (!value.is_string()) throw FieldError(std::string("\"") + name + "\" is not a text");
  return value.get<std::string>();
}

[[nodiscard]] inline int whole_number(const nlohmann::json& value, const char* name) {
  constexpr double most = std::numeric_limits<int>::max();
  if (!value.is_number_integer() || std::fabs(value.get<double>()) > most) {
    throw FieldError(std::string("\"") + name + "\" is not a whole number");
  }
  return value.get<int>();
}

/// [[x, y], [x, y], [x, y], [x, y]]
[[nodiscard]] inline Corners corners_member(const nlohmann::json& object) {
  const nlohmann::json& list = list_member(object, "corners");
  if (list.size() != 4) throw FieldError("\"corners\" is not a list of four");
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const nlohmann::json& pair = list[i];
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number()) {
      throw FieldError("a corner is not a pair of numbers");
    }
    corners[i] = {pair[0].get<double>(), pair[1].get<double>()};
  }
  return corners;
}

}  // namespace runmark
