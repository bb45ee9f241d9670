#pragma once

#include <span>
#include <vector>

#include "runmark/board.h"
#include "runmark/marker.h"

namespace runmark {

/// A marker found that has the id of one of the board's.
struct Candidate {
  int index = -1;  ///< into Board::markers
  const Marker* marker = nullptr;
  int support = 0;  ///< neighbours that lie where this one says they should
  int neighbours = 0;
};

/// Of a flat board, x and y; of a marker found, in pixels.
[[nodiscard]] Point middle_of(const BoardMarker& marker);
[[nodiscard]] Point middle_of(const Marker& marker);

/// Whether all of the board lies in the plane z = 0.
[[nodiscard]] bool is_flat(const Board& board);

/// Every marker found that may be the board's. On a flat board each looks at its nearest neighbours among the
/// others.
[[nodiscard]] std::vector<Candidate> candidates(const Board& board, std::span<const Marker> found);

/// One candidate for each marker of the board: those that the others support.
[[nodiscard]] std::vector<Candidate> agreeing(std::vector<Candidate> all);

}  // namespace runmark
