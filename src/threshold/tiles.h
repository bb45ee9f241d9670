#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "preprocess/bit_row.h"

namespace runmark {

/// Side of the square tiles of the light-following threshold, in pixels.
inline constexpr int tile_side = 4;

[[nodiscard]] constexpr int tiles_across(int width) { return (width + tile_side - 1) / tile_side; }

/// The grey rows of one row of tiles; where the frame ends early the last row stands in for the missing.
using TileBand = std::array<const std::uint8_t*, tile_side>;

/// Least, greatest and mean grey level of every tile of a band.
struct TileLight {
  explicit TileLight(std::size_t tiles) : lowest(tiles), highest(tiles), mean(tiles) {}

  std::vector<std::uint8_t> lowest;
  std::vector<std::uint8_t> highest;
  std::vector<std::uint8_t> mean;
};

/// The mean of two grey levels, halves rounded up. Means of more are means of means.
[[nodiscard]] constexpr std::uint8_t mean_of(std::uint8_t a, std::uint8_t b) {
  return static_cast<std::uint8_t>((a + b + 1) / 2);
}

/// @param light  room for tiles_across(width), and `first`
/// @param first  where the band's first tile goes
void tile_light(const TileBand& band, int width, TileLight& light, std::size_t first = 0);

/// The extremes of every tile and its left and right neighbours, and the mean of the neighbours' mean and its
/// own. A neighbour that is not there counts as the tile itself.
void spread_light(const TileLight& light, int tiles, TileLight& spread);

/// How the levels of tiles are chosen.
struct TileRule {
  int contrast = 20;     ///< extremes that differ by less are all white
  int share = 8;         ///< sixteenths of the way from the least to the greatest level, at most
  int dim_contrast = 8;  ///< the least contrast where white is twice as light as black
};

/// Three bands of tiles, spread already: above, the levels' own, below.
using ThreeBands = std::array<const TileLight*, 3>;

/// The grey level below which a pixel of each tile is dark, or 0 (all white) where the extremes of the 3x3
/// tiles round it differ by less than the rule's contrast. In the dark less is enough, since paper is still
/// twice as light as ink. Where most is dark, which the tiles' mean tells, the level is lower, by three
/// sixteenths of the way at most: thin white lines between dark shapes last.
void tile_levels(const ThreeBands& bands, int tiles, const TileRule& rule, std::uint8_t* levels);

/// Turns a grey row into bits by its band's levels.
void threshold_row(const std::uint8_t* grey, int width, const std::uint8_t* levels, BitWord* bits);

}  // namespace runmark
