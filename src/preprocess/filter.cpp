#include "preprocess/filter.h"

#include "preprocess/filter_table.h"

namespace runmark {
namespace {

/// The pixels to turn over among 64, bit by bit the rules of filter_case().
struct Masks {
  BitWord a, b, c, d, e, f;

  explicit constexpr Masks(std::uint8_t cases)
      : a(when(cases, filter_hole_with_diagonals)),
        b(when(cases, filter_diagonal_object)),
        c(when(cases, filter_diagonal_hole)),
        d(when(cases, filter_lone_object)),
        e(when(cases, filter_lone_hole)),
        f(when(cases, filter_empty_column)) {}

  static constexpr BitWord when(std::uint8_t cases, FilterCase one) {
    return (cases & one) != 0 ? ~BitWord{0} : 0;
  }
};

/// 64 pixels of a row and their neighbours to the left and right.
struct Triple {
  BitWord west, here, east;
};

constexpr Triple triple(BitWord before, BitWord here, BitWord after) {
  return {here << 1 | before >> (bits_per_word - 1), here, here >> 1 | after << (bits_per_word - 1)};
}

constexpr BitWord filtered(const Triple& above, const Triple& current, const Triple& below, const Masks& on) {
  const BitWord n = above.here, s = below.here, w = current.west, e = current.east, c = current.here;
  const BitWord any_dark = above.west | above.east | below.west | below.east;
  const BitWord any_light = ~(above.west & above.east & below.west & below.east);
  const BitWord dark_side = (above.west | below.east) & (above.east | below.west);
  const BitWord light_side = ~((above.west & below.east) | (above.east & below.west));

  const BitWord single = c & ~(n | s | w | e);
  const BitWord remove = single & ((on.d & ~any_dark) | (on.b & any_dark & ~dark_side));
  const BitWord hole = n & s & w & e;
  const BitWord fill_hole =
      hole & ((on.e & ~any_light) | (on.c & any_light & ~light_side) | (on.a & light_side));
  const BitWord column = w & e & ~(n & s) & (n | (above.west & above.east)) & (s | (below.west & below.east));
  return (c & ~remove) | (~c & (fill_hole | (on.f & column)));
}

}  // namespace

void filter_row(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                std::uint8_t cases, BitWord* out) {
  const Masks on(cases);
  const std::size_t last = bit_words(width) - 1;
  const auto word = [&](std::size_t i, const auto& before, const auto& after) {
    out[i] = filtered(triple(before(above), above[i], after(above)),
                      triple(before(current), current[i], after(current)),
                      triple(before(below), below[i], after(below)), on);
  };
  const auto none = [](const BitWord*) { return BitWord{0}; };
  if (last == 0) return word(0, none, none);
  word(0, none, [](const BitWord* row) { return row[1]; });
  for (std::size_t i = 1; i < last; ++i) {
    word(
        i, [i](const BitWord* row) { return row[i - 1]; }, [i](const BitWord* row) { return row[i + 1]; });
  }
  word(
      last, [last](const BitWord* row) { return row[last - 1]; }, none);
}

void filter_row_plain(const BitWord* above, const BitWord* current, const BitWord* below, int width,
                      std::uint8_t cases, BitWord* out) {
  for (std::size_t i = 0; i < bit_words(width); ++i) out[i] = 0;
  const auto column = [&](int x) {  // one column of the window: its bits 0, 3 and 6
    if (x >= width) return 0;
    return (bit_at(above, x) ? 1 : 0) | (bit_at(current, x) ? 8 : 0) | (bit_at(below, x) ? 64 : 0);
  };
  int window = column(0) << 2;
  for (int x = 0; x < width; ++x) {
    constexpr int left_and_middle = 0b011'011'011;
    window = (window >> 1 & left_and_middle) | column(x + 1) << 2;
    if (filter_pixel(static_cast<Window>(window), cases)) set_bit(out, x, true);
  }
}

}  // namespace runmark
