#pragma once

#include <cstdint>
#include <optional>

#include "corner/chain_extremes.h"
#include "corner/integer_quad.h"

namespace runmark {

/// A line in integers: y = at.y + slope (x - at.x) / 2^14 when it runs more across than down, else the same
/// with x and y exchanged.
struct IntegerLine {
  static constexpr int slope_bits = 14;
  bool across = true;
  SubpixelPoint at;
  std::int32_t slope = 0;  ///< from -2 to less than 2
};

/// Where two lines meet; nothing when they are within about four degrees of parallel.
[[nodiscard]] std::optional<SubpixelPoint> meet(const IntegerLine& a, const IntegerLine& b);

/// Fits a line to one side of a quadrilateral, from the cracks between its rough corners. Below, `along` is x
/// and `over` is y for a side that runs more across than down; else they change places.
class SideFit {
 public:
  SideFit() = default;
  SideFit(const NumberedVertex& from, const NumberedVertex& to);

  /// A run of cracks of the boundary. Runs in the other direction than the side's count negative, and what
  /// lies near the corners, where blur rounds the boundary, does not count.
  void add_horizontal(std::int32_t x_from, std::int32_t x_to, std::int32_t y) {
    if (across_) add(x_from, x_to, y);
  }
  void add_vertical(std::int32_t x, std::int32_t y_from, std::int32_t y_to) {
    if (!across_) add(y_from, y_to, x);
  }

  /// Nothing when the line strays from the rough corners: the side was bent.
  [[nodiscard]] std::optional<IntegerLine> line() const;

 private:
  void add(std::int32_t from, std::int32_t to, std::int32_t over);

  bool across_ = true;
  std::int32_t low_ = 0;  // limits of what counts, along the side
  std::int32_t high_ = 0;
  std::int32_t start_over_ = 0;    // of the first corner
  std::int32_t middle_over2_ = 0;  // twice the middle of the rough side, above start_over_
  std::int32_t length_ = 0;        // along
  bool backwards_ = false;         // the chain runs from high to low
  std::int64_t sum_ = 0;           // of over - start_over over all columns
  std::int64_t moment_ = 0;        // the same times twice the column's distance from the middle
};

}  // namespace runmark
