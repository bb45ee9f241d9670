#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runmark/dictionary.h"
#include "runmark/marker.h"

namespace runmark {

/// A grey picture of many markers of one dictionary, upright, side by side.
struct Sheet {
  struct Drawn {
    int id = 0;
    std::array<Point, 4> corners{};  ///< top-left, top-right, bottom-right, bottom-left of the square
  };
  int side = 0;
  std::vector<std::uint8_t> grey;  ///< side * side
  std::vector<Drawn> markers;
};

/// Under a sanitizer one sheet of each dictionary has to do: the others take the same paths, and long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool one_sheet_only = true;
#else
inline constexpr bool one_sheet_only = false;
#endif

/// Ids from `first_id` on, as many as fit on a picture of about 2,000 pixels a side.
[[nodiscard]] Sheet draw_sheet(const Dictionary& dictionary, std::size_t first_id, int pixels_per_cell,
                               int margin_cells);

/// A marker as some detector read it, in runmark's conventions.
struct Reading {
  int id = 0;
  std::array<Point, 4> corners{};
};

/// What the readings get wrong, in words: there must be exactly one for each marker of the sheet, with each
/// corner within `tolerance` pixels. Of a code that is its own rotation the corners may begin anywhere.
[[nodiscard]] std::vector<std::string> mistakes(const Sheet& sheet, const std::vector<Reading>& readings,
                                                const Dictionary& dictionary, double tolerance);

}  // namespace runmark
