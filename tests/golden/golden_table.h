#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace runmark::golden {

/// What a set of images must give after so many degrees of turning.
struct Level {
  int markers = 0;  ///< there are in the set
  int least_found = 0;
  int most_false = 0;
};

/// By set and degrees.
using GoldenTable = std::map<std::pair<std::string, int>, Level>;

/// Reads lines of set,degrees,markers,least_found,most_false below a heading. Throws std::runtime_error
/// with the line.
[[nodiscard]] GoldenTable read_golden(const std::filesystem::path& file);

void write_golden(const std::filesystem::path& file, const GoldenTable& table);

}  // namespace runmark::golden
