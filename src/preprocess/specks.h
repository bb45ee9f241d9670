#pragma once

#include "preprocess/bit_row.h"
#include "runmark/options.h"

namespace runmark {

/// Turns the specks of a row over: single pixels, dark or light, with none beside them that they are
/// connected to. Their contours are one pixel high and nothing else changes, so a contour core that drops
/// such contours anyway hands on the same chains, with fewer crack runs to follow. All specks are told by the
/// rows as they were; pixels outside the image are light.
///
/// @param above, current, below  rows of bit_words(width) words
/// @param connectivity           four or eight, of dark pixels; light ones have the other
/// @param out                    room for bit_words(width) words, none of the rows read
void drop_specks(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                 Connectivity connectivity, BitWord* out);

}  // namespace runmark
