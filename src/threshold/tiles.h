#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "preprocess/bit_row.h"

namespace runmark {

/// Side of the square tiles of the light-following threshold, in pixels.
inline constexpr int tile_side = 4;

[[nodiscard]] constexpr int tiles_across(int width) { return (width + tile_side - 1) / tile_side; }

/// The grey rows of one row of tiles; where the frame ends early the last row stands in for the missing.
using TileBand = std::array<const std::uint8_t*, tile_side>;

/// Least and greatest grey level of every tile of a band.
/// @param lowest, highest  room for tiles_across(width)
void tile_extremes(const TileBand& band, int width, std::uint8_t* lowest, std::uint8_t* highest);

/// Spreads the extremes of every tile over its left and right neighbours.
void spread_extremes(const std::uint8_t* lowest, const std::uint8_t* highest, int tiles,
                     std::uint8_t* spread_lowest, std::uint8_t* spread_highest);

/// Extremes of one band of tiles, already spread sideways.
struct TileExtremes {
  const std::uint8_t* lowest = nullptr;
  const std::uint8_t* highest = nullptr;
};

/// How the levels of tiles are chosen.
struct TileRule {
  int contrast = 20;  ///< extremes that differ by less are all white
  int share = 8;      ///< sixteenths of the way from the least to the greatest level
};

/// The grey level below which a pixel of each tile is dark: between the extremes of the three bands, or 0
/// (all white) where they differ too little.
void tile_levels(const std::array<TileExtremes, 3>& bands, int tiles, const TileRule& rule,
                 std::uint8_t* levels);

/// Turns a grey row into bits by its band's levels.
void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits);

}  // namespace runmark
