#include "golden_table.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace runmark::golden {
namespace {

constexpr const char* heading = "set,degrees,markers,least_found,most_false";

}  // namespace

GoldenTable read_golden(const std::filesystem::path& file) {
  std::ifstream stream(file);
  GoldenTable table;
  std::string line;
  if (!std::getline(stream, line) || line != heading)
    throw std::runtime_error(file.string() + ":1: no heading");
  for (int number = 2; std::getline(stream, line); ++number) {
    std::array<char, 64> set{};
    int degrees = 0;
    Level level;
    if (std::sscanf(line.c_str(), "%63[^,],%d,%d,%d,%d", set.data(), &degrees, &level.markers,
                    &level.least_found, &level.most_false) != 5) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": not five values");
    }
    table[{set.data(), degrees}] = level;
  }
  return table;
}

void write_golden(const std::filesystem::path& file, const GoldenTable& table) {
  std::ofstream out(file);
  out << heading << '\n';
  for (const auto& [key, level] : table) {
    out << key.first << ',' << key.second << ',' << level.markers << ',' << level.least_found << ','
        << level.most_false << '\n';
  }
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace runmark::golden
