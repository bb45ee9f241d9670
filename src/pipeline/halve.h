#pragma once

#include <cstdint>

namespace runmark {

/// Averages 2x2 pixels of two rows, rounded: `width` pixels of the half-size row.
void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* half);

}  // namespace runmark
