#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "corner/integer_quad.h"
#include "pattern/code_lookup.h"
#include "pattern/grey_frame.h"
#include "pattern/integer_light.h"
#include "runmark/dictionary.h"

namespace runmark {

/// What the integer reader accepts.
struct IntegerReaderLimits {
  int corrected_bits = -1;  ///< for every dictionary, or -1 for each dictionary's own
  int min_margin = 13;      ///< in 1/256 of the contrast
};

/// A marker read in integers.
struct IntegerReading {
  const Dictionary* dictionary = nullptr;
  CodeMatch match;
  std::int32_t clearance = 0;  ///< sum over the cells of how far each is from being the other colour
  std::int32_t scale = 1;      ///< what the sum would be if every cell were a whole contrast away
};

/// The cells of a square in the order of a row-major code: 1 = white. What the sampler makes of a
/// quadrilateral.
struct CellBits {
  std::uint64_t code = 0;  ///< of the cells within the border, the first in the highest bit
  std::int32_t clearance = 0;
  std::int32_t scale = 1;
};

/// Grey level, in sixteenths, between four pixels; beyond the frame or below `last_row` the nearest counts.
[[nodiscard]] FineGrey grey_between(const GreyFrame& frame, int last_row, SubpixelPoint p);

/// Reads a square of `width` cells in the image: places all cells from its four corners, finds the light from
/// the border and the ring outside, checks the border and tells the cells' colours. Nothing when the corners
/// are not convex, the contrast is less than 8 grey levels or too much of the border is white.
[[nodiscard]] std::optional<CellBits> read_cells(const GreyFrame& frame, int last_row,
                                                 const IntegerQuad& quad, int width);

/// The pattern core of `--pipeline hardware`, in integers: cells as above, then the code looked up in four
/// rotations.
class IntegerReader {
 public:
  static constexpr int least_width = 6;
  static constexpr int most_width = 10;

  IntegerReader(const std::vector<Dictionary>& dictionaries, const IntegerReaderLimits& limits);

  /// It reads dictionaries of a full square of 4x4 to 8x8 cells in a black border.
  [[nodiscard]] static bool can_read(const Dictionary& dictionary);

  /// The marker with the fewest corrected bits among all dictionaries, then the one asked for first.
  [[nodiscard]] std::optional<IntegerReading> read(const GreyFrame& frame, int last_row,
                                                   const IntegerQuad& quad) const;
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Book {
    const Dictionary* dictionary = nullptr;
    CodeLookup lookup;
  };
  IntegerReaderLimits limits_;
  std::array<std::vector<Book>, most_width + 1> books_;  // by the marker's width
};

}  // namespace runmark
