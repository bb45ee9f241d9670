#include "pipeline/halve.h"

namespace runmark {

void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half) {
  for (int x = 0; x < width; ++x) {
    half[x] = static_cast<std::uint8_t>(
        (upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1] + 2) / 4);
  }
}

}  // namespace runmark
