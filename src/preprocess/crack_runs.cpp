#include "preprocess/crack_runs.h"

#include <bit>

namespace runmark {

std::size_t find_crack_runs(const BitWord* above, const BitWord* current, int width,
                            Connectivity connectivity, std::span<CrackRun> runs) {
  const std::size_t words = bit_words(width);
  const bool eight = connectivity == Connectivity::eight;
  std::size_t count = 0;
  bool inside = false;  // a run has begun and not ended
  CrackRun run;
  BitWord top_carry = 0;  // the last pixel of the word before, as bit 0
  BitWord bottom_carry = 0;
  BitWord above_carry = 0;

  for (std::size_t w = 0; w < words; ++w) {
    if (above[w] == current[w] && !inside) {
      above_carry = above[w] >> (bits_per_word - 1);
      top_carry = 0;
      bottom_carry = 0;
      continue;
    }
    const BitWord top = current[w] & ~above[w];
    const BitWord bottom = above[w] & ~current[w];
    const BitWord top_ends = top ^ ((top << 1) | top_carry);
    const BitWord bottom_ends = bottom ^ ((bottom << 1) | bottom_carry);
    const BitWord cracks_above = above[w] ^ ((above[w] << 1) | above_carry);
    top_carry = top >> (bits_per_word - 1);
    bottom_carry = bottom >> (bits_per_word - 1);
    above_carry = above[w] >> (bits_per_word - 1);

    for (BitWord ends = top_ends | bottom_ends; ends != 0; ends &= ends - 1) {
      const int bit = std::countr_zero(ends);
      const auto x = static_cast<std::uint16_t>(w * bits_per_word + static_cast<std::size_t>(bit));
      const bool crosswise = ((top_ends & bottom_ends) >> bit & 1U) != 0;
      const bool crack_above = (cracks_above >> bit & 1U) != 0;
      const bool left_takes_above = crosswise ? run.top == eight : crack_above;
      if (inside) {
        run.x1 = x;
        run.right_above = left_takes_above;
        runs[count++] = run;
      }
      inside = !inside || crosswise;
      if (inside) {
        run.x0 = x;
        run.top = (top >> bit & 1U) != 0;
        run.left_above = crosswise ? !left_takes_above : crack_above;
      }
    }
  }
  return count;
}

}  // namespace runmark
