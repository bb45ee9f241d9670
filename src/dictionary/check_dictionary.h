#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "runmark/dictionary.h"

namespace runmark {

inline constexpr std::size_t max_data_cells = 64;
inline constexpr std::size_t max_codes = 65536;
inline constexpr int max_cells_per_side = 16;  ///< inside the border ring

/// What is wrong with the dictionary's cells: none or too many, twice the same, on the border ring or
/// beyond where its kind of border allows data, or not mapped onto themselves by a quarter turn.
[[nodiscard]] std::optional<std::string> check_cells(const Dictionary& dictionary);

/// What is wrong with the number of corrected bits: more than keep codes of that distance apart.
[[nodiscard]] std::optional<std::string> check_corrected_bits(const Dictionary& dictionary);

/// What is wrong with a dictionary, whoever made it; nothing when a detector can use it.
[[nodiscard]] std::optional<std::string> check_dictionary(const Dictionary& dictionary);

}  // namespace runmark
