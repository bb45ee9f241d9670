#pragma once

#include <cstdint>

namespace runmark::fast {

/// The same as halve_rows, many pixels at a time.
void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half);

}  // namespace runmark::fast
