#pragma once

#include <cstdint>

#include "preprocess/bit_row.h"
#include "threshold/tiles.h"

/// The forms of the cores that take many pixels at a time, by the widest vectors of the processor they run
/// on. Each does what the function of the same name outside `fast` does, bit for bit.
namespace runmark::fast {

void tile_light(const TileBand& band, int width, TileLight& light);
void tile_levels(const ThreeBands& bands, int tiles, const TileRule& rule, std::uint8_t* levels);
void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits);

}  // namespace runmark::fast
