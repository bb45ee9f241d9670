#include "pattern/integer_light.h"

namespace runmark {
namespace {

/// One over `divisor`, in 1/2^bits, rounded: constants in hardware.
constexpr std::int64_t reciprocal(std::int64_t divisor, int bits) {
  return ((std::int64_t{1} << bits) + divisor / 2) / divisor;
}

/// Squared distances, in half cells along one axis, of all cells of the two rings from the middle.
constexpr std::int64_t spread(int width) {
  std::int64_t sum = 0;
  for (int row = -1; row <= width; ++row) {
    for (int column = -1; column <= width; ++column) {
      const bool beyond_row = row < 0 || row == width;
      const bool beyond_column = column < 0 || column == width;
      const bool edge = row == 0 || row == width - 1 || column == 0 || column == width - 1;
      const bool counts = beyond_row ? !beyond_column : beyond_column || edge;
      if (counts) sum += (2 * column + 1 - width) * (2 * column + 1 - width);
    }
  }
  return sum;
}

}  // namespace

IntegerLight::IntegerLight(int width) : width_(width) {}

void IntegerLight::add(int column, int row, FineGrey grey) {
  const bool outside = column < 0 || row < 0 || column == width_ || row == width_;
  (outside ? white_ : black_) += grey;
  moment_x_ += static_cast<std::int64_t>(grey) * centred(column);
  moment_y_ += static_cast<std::int64_t>(grey) * centred(row);
}

void IntegerLight::finish() {
  // Half the mean of each ring.
  const std::int64_t half_black = black_ * reciprocal(8 * (width_ - 1), 16);
  const std::int64_t half_white = white_ * reciprocal(8 * width_, 16);
  level_ = static_cast<FineGrey>((half_black + half_white) >> 16);
  contrast_ = static_cast<FineGrey>((half_white - half_black) >> 15);
  const std::int64_t share = reciprocal(spread(width_), 24);
  across_ = static_cast<std::int32_t>((moment_x_ * share) >> 16);
  down_ = static_cast<std::int32_t>((moment_y_ * share) >> 16);
}

}  // namespace runmark
