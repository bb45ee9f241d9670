#include "pattern/edge_rises.h"

// Each line's sums are its own, so all vector extensions give the same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pattern/edge_rises.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 8>;  // most_lines is a multiple
using Vector = hn::Vec<Floats>;

HWY_INLINE int Step() { return static_cast<int>(hn::Lanes(Floats())); }

void SquareMoments(const EdgeRises& rises, float reach, EdgeMoments& moments) {
  const Floats d;
  const auto zero = hn::Zero(d);
  for (int i = 0; i < EdgeRises::most_lines; i += Step()) {
    auto n = hn::LoadU(d, rises.first + i);
    auto weight = zero;
    auto sum = zero;
    for (int k = 0; k < rises.rises; ++k) {
      const auto kept = hn::Max(hn::LoadU(d, rises.rise[k] + i), zero);
      const auto near = hn::Le(hn::Abs(n), hn::Set(d, reach));
      const auto square = hn::IfThenElseZero(near, hn::Mul(kept, kept));
      weight = hn::Add(weight, square);
      sum = hn::Add(sum, hn::Mul(square, n));
      n = hn::Add(n, hn::Set(d, 1.0F));
    }
    hn::StoreU(weight, d, moments.weight + i);
    hn::StoreU(sum, d, moments.sum + i);
  }
}

/// How much of a rise at a distance lies in the window: 0 to 1 over the pixel at its rim.
HWY_INLINE Vector Inside(Vector distance, Vector rim) {
  const Floats d;
  return hn::Min(hn::Max(hn::Sub(rim, distance), hn::Zero(d)), hn::Set(d, 1.0F));
}

float WindowMoments(const EdgeRises& rises, const float* offset, float width, EdgeMoments& moments) {
  const Floats d;
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0F);
  const auto rim = hn::Set(d, width + 0.5F);
  float cut[EdgeRises::most_lines];
  for (int i = 0; i < EdgeRises::most_lines; i += Step()) {
    auto n = hn::Sub(hn::LoadU(d, rises.first + i), hn::LoadU(d, offset + i));
    auto weight = zero;
    auto sum = zero;
    auto at_rim = zero;
    for (int k = 0; k < rises.rises; ++k) {
      const auto kept = hn::Max(hn::LoadU(d, rises.rise[k] + i), zero);
      const auto distance = hn::Abs(n);
      const auto inside = Inside(distance, rim);
      const auto part = hn::Mul(inside, kept);
      weight = hn::Add(weight, part);
      sum = hn::Add(sum, hn::Mul(part, n));
      const auto is_cut = hn::And(hn::Gt(inside, zero), hn::Lt(inside, one));
      at_rim = hn::Add(at_rim, hn::IfThenElseZero(is_cut, hn::Mul(kept, distance)));
      n = hn::Add(n, one);
    }
    hn::StoreU(weight, d, moments.weight + i);
    hn::StoreU(sum, d, moments.sum + i);
    hn::StoreU(at_rim, d, cut + i);
  }
  float all = 0;
  for (int i = 0; i < rises.lines; ++i) all += cut[i];
  return all;
}

float WindowSum(const EdgeRises& rises, const float* offset, float width) {
  const Floats d;
  const auto rim = hn::Set(d, width + 0.5F);
  float sums[EdgeRises::most_lines];
  for (int i = 0; i < EdgeRises::most_lines; i += Step()) {
    auto n = hn::Sub(hn::LoadU(d, rises.first + i), hn::LoadU(d, offset + i));
    auto sum = hn::Zero(d);
    for (int k = 0; k < rises.rises; ++k) {
      sum = hn::Add(sum, hn::Mul(Inside(hn::Abs(n), rim), hn::LoadU(d, rises.rise[k] + i)));
      n = hn::Add(n, hn::Set(d, 1.0F));
    }
    hn::StoreU(sum, d, sums + i);
  }
  float all = 0;
  for (int i = 0; i < rises.lines; ++i) all += sums[i];
  return all;
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark {

HWY_EXPORT(SquareMoments);
HWY_EXPORT(WindowMoments);
HWY_EXPORT(WindowSum);

void square_moments(const EdgeRises& rises, float reach, EdgeMoments& moments) {
  HWY_DYNAMIC_DISPATCH(SquareMoments)(rises, reach, moments);
}

float window_moments(const EdgeRises& rises, const float* offset, float width, EdgeMoments& moments) {
  return HWY_DYNAMIC_DISPATCH(WindowMoments)(rises, offset, width, moments);
}

float window_sum(const EdgeRises& rises, const float* offset, float width) {
  return HWY_DYNAMIC_DISPATCH(WindowSum)(rises, offset, width);
}

}  // namespace runmark
#endif
