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

/// Sets that number.
template <class Port>
void set_part(Port& port, unsigned index, unsigned bits, int value) {
  for (unsigned b = 0; b < bits; ++b) {
    const unsigned at = index * bits + b;
    const bool bit = (value >> b & 1) != 0;
    if constexpr (requires { port[0]; }) {
      const std::uint32_t mask = std::uint32_t{1} << (at % 32);
      port[at / 32] = bit ? port[at / 32] | mask : port[at / 32] & ~mask;
    } else {
      const auto mask = static_cast<Port>(Port{1} << at);
      port = static_cast<Port>(bit ? port | mask : port & ~mask);
    }
  }
}

}  // namespace runmark::rtl
