#pragma once

#include <array>
#include <cstdint>

#include "preprocess/bit_row.h"
#include "threshold/tiles.h"

/// The forms of the cores that take many pixels at a time, by the widest vectors of the processor they run
/// on. Each does what the function of the same name outside `fast` does, bit for bit.
namespace runmark::fast {

void tile_extremes(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest);
void tile_levels(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                 std::uint8_t* levels);
void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits);

}  // namespace runmark::fast
