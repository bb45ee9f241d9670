#include "threshold/fixed_threshold.h"

#include <algorithm>

namespace runmark {

void threshold_row(const std::uint8_t* grey, int width, const FixedThreshold& threshold, BitWord* bits) {
  std::fill_n(bits, bit_words(width), BitWord{0});
  for (int x = 0; x < width; ++x) {
    if (threshold.dark(grey[x])) bits[x / bits_per_word] |= BitWord{1} << (x % bits_per_word);
  }
}

}  // namespace runmark
