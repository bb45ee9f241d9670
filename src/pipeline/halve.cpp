#include "pipeline/halve.h"

namespace runmark {

void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half) {
  const std::uint8_t* __restrict a = upper;
  const std::uint8_t* __restrict b = lower;
  std::uint8_t* __restrict out = half;
  for (int x = 0; x < width; ++x) {
    const auto sum = static_cast<std::uint16_t>(a[2 * x] + a[2 * x + 1] + b[2 * x] + b[2 * x + 1] + 2);
    out[x] = static_cast<std::uint8_t>(sum / 4);
  }
}

}  // namespace runmark
