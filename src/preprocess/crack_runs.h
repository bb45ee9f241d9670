#pragma once

#include <cstddef>
#include <span>

#include "preprocess/bit_row.h"
#include "preprocess/crack_run.h"
#include "runmark/options.h"

namespace runmark {

/// The most runs a row of that width can have.
[[nodiscard]] constexpr std::size_t max_crack_runs(int width) { return static_cast<std::size_t>(width) + 1; }

/// Finds the crack runs between `above` and `current`, left to right: the runs of ones of row XOR row
/// above, told apart by which row is dark (docs/design.md, contours from crack events).
///
/// Where a top run touches a bottom run four pixels meet crosswise, and the two runs share the two
/// vertical cracks there: the left run takes the one above if it is a top run under 8-connectivity, or
/// a bottom run under 4-connectivity, else the one below; the right run takes the other. That choice
/// alone is the connectivity of dark pixels.
///
/// `connectivity` is four or eight.
/// @param above, current  rows of bit_words(width) words
/// @param runs            room for max_crack_runs(width)
/// @return how many runs were written
std::size_t find_crack_runs(const BitWord* above, const BitWord* current, int width,
                            Connectivity connectivity, std::span<CrackRun> runs);

}  // namespace runmark
