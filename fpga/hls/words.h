#pragma once

#include <cstdint>

#include "corner/corner_state_machine.h"
#include "preprocess/crack_run.h"

// What the cores hand to one another: plain 64 bit integers.
namespace runmark::hls_form {

using Word = std::uint64_t;

[[nodiscard]] constexpr unsigned field(Word word, unsigned shift, unsigned bits) {
  return static_cast<unsigned>(word >> shift & ((Word{1} << bits) - 1));
}

/// preprocess to contour: a crack run, or the end of the crack line y, which is the frame's last or not.
[[nodiscard]] constexpr Word run_word(const CrackRun& run) {
  return Word{run.x0} | Word{run.x1} << 16 | Word{run.top} << 32 | Word{run.left_above} << 33 |
         Word{run.right_above} << 34;
}
[[nodiscard]] constexpr CrackRun run_of(Word word) {
  return {static_cast<std::uint16_t>(field(word, 0, 16)), static_cast<std::uint16_t>(field(word, 16, 16)),
          field(word, 32, 1) != 0, field(word, 33, 1) != 0, field(word, 34, 1) != 0};
}
[[nodiscard]] constexpr Word line_end_word(int y, bool last) {
  return static_cast<Word>(y) | Word{1} << 40 | Word{last} << 41;
}
[[nodiscard]] constexpr bool is_line_end(Word word) { return field(word, 40, 1) != 0; }
[[nodiscard]] constexpr bool is_last(Word word) { return field(word, 41, 1) != 0; }

/// contour to corner: the records of a chain from head to tail, or the end of the frame.
[[nodiscard]] constexpr Word record_word(unsigned x, unsigned y, bool tail, bool hole) {
  return Word{x} | Word{y} << 16 | Word{tail} << 32 | Word{hole} << 33;
}
inline constexpr Word frame_end = Word{1} << 63;

/// corner to pattern, pattern to the outside: two words of two places each, then a word of what is known.
[[nodiscard]] constexpr Word places_word(CrackPoint a, CrackPoint b) {
  return static_cast<Word>(a.x) | static_cast<Word>(a.y) << 16 | static_cast<Word>(b.x) << 32 |
         static_cast<Word>(b.y) << 48;
}
[[nodiscard]] constexpr CrackPoint place_of(Word word, unsigned which) {
  return {static_cast<int>(field(word, 32 * which, 16)), static_cast<int>(field(word, 32 * which + 16, 16))};
}
[[nodiscard]] constexpr Word quad_word(unsigned bottom, bool hole) { return Word{bottom} | Word{hole} << 16; }
[[nodiscard]] constexpr Word marker_word(unsigned id, unsigned errors, bool hole) {
  return Word{id} | Word{errors} << 16 | Word{hole} << 24;
}

}  // namespace runmark::hls_form
