#pragma once

#include "preprocess/specks.h"

namespace runmark::fast {

/// The same as drop_specks, many pixels at a time.
void drop_specks(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                 Connectivity connectivity, BitWord* out);

}  // namespace runmark::fast
