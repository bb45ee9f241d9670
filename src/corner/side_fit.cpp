#include "corner/side_fit.h"

#include <algorithm>
#include <cstdlib>

namespace runmark {
namespace {

/// The quotient rounded down, of a positive divisor.
std::int64_t floor_of(std::int64_t dividend, std::int64_t divisor) {
  return dividend < 0 ? ~(~dividend / divisor) : dividend / divisor;
}

/// What rounding down makes of the opposite number, but for whole ones: a complement, which costs no adder.
std::int64_t turned(std::int64_t rounded, bool opposite) { return opposite ? ~rounded : rounded; }

}  // namespace

SideFit::SideFit(const NumberedVertex& from, const NumberedVertex& to) {
  const std::int32_t dx = to.x - from.x;
  const std::int32_t dy = to.y - from.y;
  across_ = std::abs(dx) >= std::abs(dy);
  const std::int32_t start = across_ ? from.x : from.y;
  const std::int32_t end = across_ ? to.x : to.y;
  start_over_ = across_ ? from.y : from.x;
  backwards_ = end < start;
  middle_over2_ = across_ ? dy : dx;
  length_ = std::abs(end - start);
  const std::int32_t margin = length_ < 5 ? 0 : 1 + (length_ >> 4);
  low_ = std::min(start, end) + margin;
  high_ = std::max(start, end) - margin;
}

void SideFit::add(std::int32_t from, std::int32_t to, std::int32_t over) {
  const std::int32_t a = std::clamp(from, low_, high_);
  const std::int32_t b = std::clamp(to, low_, high_);
  const std::int64_t weighted = static_cast<std::int64_t>(b - a) * (over - start_over_);
  sum_ += weighted;
  moment_ += weighted * (a + b - low_ - high_);
}

std::optional<IntegerLine> SideFit::line() const {
  const std::int64_t n = high_ - low_;
  if (n < 2) return std::nullopt;
  // The columns' squared distances from their middle add up to n (n n - 1) / 12.
  const std::int64_t spread = n * (n * n - 1);
  constexpr std::int64_t one = std::int64_t{1} << IntegerLine::slope_bits;
  const std::int64_t fitted = turned(floor_of(moment_ * 6 * one, spread), backwards_);
  if (fitted < -2 * one || fitted >= 2 * one) return std::nullopt;
  const auto slope = static_cast<std::int32_t>(fitted);
  const std::int64_t mean =
      turned(floor_of(sum_ * (1 << subpixel_bits), n), backwards_);  // above start_over_

  // Against the middle of the rough side.
  const std::int64_t off_middle = 2 * mean - (std::int64_t{middle_over2_} << subpixel_bits);
  if (std::abs(off_middle) > 2 * ((2 << subpixel_bits) + length_)) return std::nullopt;

  // A crack lies half a pixel before the centre of the pixel behind it.
  const std::int32_t along = ((low_ + high_) << (subpixel_bits - 1)) - (1 << (subpixel_bits - 1));
  const std::int32_t over =
      (start_over_ << subpixel_bits) + static_cast<std::int32_t>(mean) - (1 << (subpixel_bits - 1));
  return IntegerLine{across_, across_ ? SubpixelPoint{along, over} : SubpixelPoint{over, along}, slope};
}

std::optional<SubpixelPoint> meet(const IntegerLine& a, const IntegerLine& b) {
  constexpr int bits = IntegerLine::slope_bits;
  constexpr std::int64_t one = std::int64_t{1} << bits;
  const std::int64_t ax = a.across ? one : a.slope;
  const std::int64_t ay = a.across ? a.slope : one;
  const std::int64_t bx = b.across ? one : b.slope;
  const std::int64_t by = b.across ? b.slope : one;
  const std::int64_t sine = (ax * by - ay * bx) >> (bits - 2);  // in 1 / 2^16
  if (std::abs(sine) < one / 4) return std::nullopt;
  const std::int64_t apart = (b.at.x - a.at.x) * by - (b.at.y - a.at.y) * bx;  // in 1 / 2^14
  const std::int64_t t = turned(floor_of(apart * 4, std::abs(sine)), sine < 0);
  constexpr std::int64_t farthest = std::int64_t{1} << 17;
  if (std::abs(t) >= farthest) return std::nullopt;
  return SubpixelPoint{a.at.x + static_cast<std::int32_t>((t * ax) >> bits),
                       a.at.y + static_cast<std::int32_t>((t * ay) >> bits)};
}

}  // namespace runmark
