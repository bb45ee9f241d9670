#include "preprocess/specks.h"

namespace runmark {
namespace {

/// Whether the pixel at x and all beside it, as far as they are connected to one of its colour, are of the
/// other colour.
bool is_speck(const BitWord* above, const BitWord* current, const BitWord* below, int x, int width,
              bool eight) {
  const auto dark = [&](const BitWord* row, int at) { return at >= 0 && at < width && bit_at(row, at); };
  const bool own = bit_at(current, x);
  const auto other = [&](const BitWord* row, int at) { return dark(row, at) != own; };
  const bool sides = other(above, x) && other(below, x) && other(current, x - 1) && other(current, x + 1);
  const bool with_diagonals = own == eight;
  return sides && (!with_diagonals || (other(above, x - 1) && other(above, x + 1) && other(below, x - 1) &&
                                       other(below, x + 1)));
}

}  // namespace

void drop_specks(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                 Connectivity connectivity, BitWord* out) {
  const bool eight = connectivity == Connectivity::eight;
  for (std::size_t i = 0; i < bit_words(width); ++i) out[i] = 0;
  for (int x = 0; x < width; ++x) {
    set_bit(out, x, bit_at(current, x) != is_speck(above, current, below, x, width, eight));
  }
}

}  // namespace runmark
