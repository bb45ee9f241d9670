#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace runmark {

/// The least number of characters to insert, delete or replace to make one text the other (Levenshtein),
/// letter case ignored.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The names closest to `name`, best first, at most three, as "a, b or c".
[[nodiscard]] std::string closest_names(std::string_view name, std::span<const std::string_view> names);

}  // namespace runmark
