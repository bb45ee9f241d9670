#include "dictionary/code_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dictionary/cell_rotation.h"

namespace runmark {

namespace {

std::array<std::uint64_t, 4> rotations(const CellRotation& rotation, std::uint64_t code) {
  std::array<std::uint64_t, 4> all{code};
  for (std::size_t r = 1; r < 4; ++r) all[r] = rotation.turned_back(all[r - 1]);
  return all;
}

}  // namespace

int least_distance(const Dictionary& dictionary) {
  const CellRotation rotation(dictionary.cells, dictionary.width);
  int least = static_cast<int>(dictionary.cells.size());
  for (std::size_t i = 0; i < dictionary.codes.size(); ++i) {
    const auto turned = rotations(rotation, dictionary.codes[i]);
    for (std::size_t r = 1; r < 4; ++r) {
      if (turned[r] != turned[0]) least = std::min(least, std::popcount(turned[r] ^ turned[0]));
    }
    for (std::size_t j = i + 1; j < dictionary.codes.size(); ++j) {
      for (const std::uint64_t code : turned) {
        least = std::min(least, std::popcount(code ^ dictionary.codes[j]));
      }
    }
  }
  return least;
}

std::optional<std::pair<std::size_t, std::size_t>> equal_codes(const Dictionary& dictionary) {
  const CellRotation rotation(dictionary.cells, dictionary.width);
  std::vector<std::pair<std::uint64_t, std::size_t>> lowest;  // of the four rotations, and the id
  lowest.reserve(dictionary.codes.size());
  for (const std::uint64_t code : dictionary.codes) {
    lowest.emplace_back(std::ranges::min(rotations(rotation, code)), lowest.size());
  }
  std::ranges::sort(lowest);
  const auto twice =
      std::ranges::adjacent_find(lowest, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == lowest.end()) return std::nullopt;
  return std::pair{twice->second, std::next(twice)->second};
}

double accepted_share(std::size_t bits, std::size_t codes, int corrected) {
  double choose = 1;  // C(bits, k)
  double sum = 1;
  for (int k = 1; k <= corrected; ++k) {
    choose = choose * (static_cast<double>(bits) - k + 1) / k;
    sum += choose;
  }
  return std::ldexp(4 * static_cast<double>(codes) * sum, -static_cast<int>(bits));
}

int safe_corrected_bits(std::size_t bits, std::size_t codes, int distance) {
  const double most = std::ldexp(1.0, -12);
  int k = 0;
  while (2 * (k + 1) < distance && accepted_share(bits, codes, k + 1) <= most) ++k;
  return k;
}

}  // namespace runmark
