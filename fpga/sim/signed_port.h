#pragma once

#include <cstddef>
#include <cstdint>

namespace runmark::rtl {

/// Number `index` of those of `bits` bits, two's complement, that a port of whatever width holds side by
/// side.
template <class Port>
int signed_part(const Port& port, unsigned index, unsigned bits) {
  std::int64_t value = 0;
  for (unsigned b = 0; b < bits; ++b) {
    const unsigned at = index * bits + b;
    std::uint64_t bit = 0;
    if constexpr (requires { port[0]; }) {
      bit = port[at / 32] >> (at % 32) & 1U;
    } else {
      bit = static_cast<std::uint64_t>(port) >> at & 1U;
    }
    value |= static_cast<std::int64_t>(bit) << b;
  }
  const std::int64_t sign = std::int64_t{1} << (bits - 1);
  return static_cast<int>((value ^ sign) - sign);
}

}  // namespace runmark::rtl
