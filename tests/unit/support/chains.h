#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contour/contour_linker.h"
#include "preprocess/crack_runs.h"

namespace runmark::test {

/// Follows the contours of a picture given as dark(x, y) and hands each closed chain to `visit`.
template <class Dark, class Visit>
void follow_contours(int width, int height, Dark&& dark, Visit&& visit) {
  std::vector<Record> records(20000);
  std::vector<ChainEnd> ends(max_chain_ends(width));
  std::vector<EndIndex> end_at(static_cast<std::size_t>(width) + 1);
  std::vector<CrackRun> runs(max_crack_runs(width));
  ContourLinker linker(records, ends, end_at, {.max_turns = 1000, .max_records = 10000});
  std::vector<BitWord> above(bit_words(width));
  std::vector<BitWord> current(bit_words(width));
  for (int y = 0; y <= height; ++y) {
    for (int x = 0; x < width; ++x) set_bit(current.data(), x, y < height && dark(x, y));
    const std::size_t count = find_crack_runs(above.data(), current.data(), width, Connectivity::eight, runs);
    linker.row(static_cast<std::uint16_t>(y), std::span<const CrackRun>(runs).first(count), visit);
    std::swap(above, current);
  }
}

}  // namespace runmark::test
