#pragma once

#include <cstddef>
#include <cstdint>

namespace runmark {

/// One row of binary pixels: pixel x is bit x % 64 of word x / 64, 1 = dark. A row of width w has
/// bit_words(w) words and bits at or beyond w are 0. There is always room for one bit more than the
/// width, so that the crack right of the last pixel has a bit of its own.
using BitWord = std::uint64_t;
inline constexpr int bits_per_word = 64;

[[nodiscard]] constexpr std::size_t bit_words(int width) {
  return static_cast<std::size_t>(width / bits_per_word + 1);
}

[[nodiscard]] constexpr bool bit_at(const BitWord* row, int x) {
  return ((row[x / bits_per_word] >> (x % bits_per_word)) & 1U) != 0;
}

constexpr void set_bit(BitWord* row, int x, bool value) {
  const BitWord mask = BitWord{1} << (x % bits_per_word);
  BitWord& word = row[x / bits_per_word];
  word = value ? (word | mask) : (word & ~mask);
}

}  // namespace runmark
