#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "runmark/options.h"

namespace runmark {

/// A 3x3 window of unfiltered pixels as a number below 512, 1 = dark:
///
///     bit 0  bit 1  bit 2        nw  n  ne
///     bit 3  bit 4  bit 5         w  c  e
///     bit 6  bit 7  bit 8        sw  s  se
using Window = std::uint16_t;
inline constexpr std::size_t window_count = 512;

/// The case of the paper's Fig. 2 that a window shows, or filter_none. No window shows two, so the cases
/// need no order; docs/preprocess.md says why these rules never make a new diagonal contact.
[[nodiscard]] constexpr FilterCase filter_case(Window window) {
  const auto dark = [window](int bit) { return (window >> bit & 1) != 0; };
  const bool nw = dark(0), n = dark(1), ne = dark(2);
  const bool w = dark(3), c = dark(4), e = dark(5);
  const bool sw = dark(6), s = dark(7), se = dark(8);

  if (c && !(n || s || w || e)) {
    if (!(nw || ne || sw || se)) return filter_lone_object;
    // Two dark corners on one side may be, with this pixel, the rim of a hole of case (a): filling the
    // hole and removing its rim at once would turn the figure inside out.
    const bool two_on_a_side = (nw || se) && (ne || sw);
    return two_on_a_side ? filter_none : filter_diagonal_object;
  }
  if (!c && n && s && w && e) {
    if (nw && ne && sw && se) return filter_lone_hole;
    // Two light corners on one side: the rim pixel between them holds on by its own corners only.
    const bool two_on_a_side = (!nw || !se) && (!ne || !sw);
    return two_on_a_side ? filter_hole_with_diagonals : filter_diagonal_hole;
  }
  if (!c && w && e) {
    const bool walled_above = n || (nw && ne);
    const bool walled_below = s || (sw && se);
    if (walled_above && walled_below) return filter_empty_column;
  }
  return filter_none;
}

/// The filter's definition: the case that each of the 512 windows shows.
inline constexpr std::array<FilterCase, window_count> filter_table = [] {
  std::array<FilterCase, window_count> table{};
  for (std::size_t window = 0; window < window_count; ++window) {
    table[window] = filter_case(static_cast<Window>(window));
  }
  return table;
}();

/// Whether the window's centre is dark once the cases that are on (bits of FilterCase) are mended:
/// a window that shows one of them has its centre turned over.
[[nodiscard]] constexpr bool filter_pixel(Window window, std::uint8_t cases) {
  const bool centre = (window >> 4 & 1) != 0;
  return centre != ((filter_table[window] & cases) != 0);
}

}  // namespace runmark
