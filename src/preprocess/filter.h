#pragma once

#include <cstdint>

#include "preprocess/bit_row.h"

namespace runmark {

/// Filters one row: every pixel by the 3x3 window of unfiltered pixels round it (preprocess/filter_table.h).
/// Pixels outside the image are light; above its first and below its last row give a row of zeros. A pixel
/// on the image's edge may only turn light, so the white border stays white.
///
/// @param above, current, below  rows of bit_words(width) words, unfiltered
/// @param cases                  bits of FilterCase to mend
/// @param out                    room for bit_words(width) words, none of the rows read
void filter_row(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                std::uint8_t cases, BitWord* out);

/// The same by looking up each pixel's window in the table: the definition that filter_row is held to.
void filter_row_plain(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                      std::uint8_t cases, BitWord* out);

}  // namespace runmark
