#include "dictionary/edit_distance.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace runmark {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);  // distances of a's beginning so far to each beginning of b
  std::iota(row.begin(), row.end(), std::size_t{0});
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string closest_names(std::string_view name, std::span<const std::string_view> names) {
  constexpr std::size_t longest = 64;  // beyond it the answer could only be far off, and slow
  std::vector<std::string_view> sorted(names.begin(), names.end());
  std::ranges::stable_sort(sorted, {},
                           [&](std::string_view n) { return edit_distance(name.substr(0, longest), n); });
  sorted.resize(std::min<std::size_t>(sorted.size(), 3));
  std::string text;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i > 0) text += i + 1 == sorted.size() ? " or " : ", ";
    text += sorted[i];
  }
  return text;
}

}  // namespace runmark
