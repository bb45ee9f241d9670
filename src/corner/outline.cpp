#include "corner/outline.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "corner/outline.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, Outline::slack>;
using Vector = hn::Vec<Floats>;

/// The greatest value seen in each lane above `least`, and where it was first.
class Greatest {
 public:
  explicit Greatest(float least) : value_(hn::Set(Floats(), least)), place_(hn::Zero(Floats())) {}

  void Add(Vector value, Vector place) {
    const auto more = hn::Gt(value, value_);
    value_ = hn::IfThenElse(more, value, value_);
    place_ = hn::IfThenElse(more, place, place_);
  }

  /// The first place of the greatest value, `none` where no value was above `least`.
  [[nodiscard]] std::size_t Place(float least, std::size_t none) const {
    const Floats d;
    const auto most = hn::MaxOfLanes(d, value_);
    if (hn::GetLane(most) <= least) return none;
    const auto beyond = hn::Set(d, std::numeric_limits<float>::max());
    const auto first = hn::MinOfLanes(d, hn::IfThenElse(hn::Eq(value_, most), place_, beyond));
    return static_cast<std::size_t>(hn::GetLane(first));
  }

 private:
  Vector value_;
  Vector place_;
};

/// Calls visit(dx, dy, places, valid) for all vertices relative to vertex `from`.
template <class Visit>
HWY_INLINE void ForAll(const Outline& outline, std::size_t from, Visit&& visit) {
  const Floats d;
  const auto x0 = hn::Set(d, outline.x[from]);
  const auto y0 = hn::Set(d, outline.y[from]);
  const auto count = hn::Set(d, static_cast<float>(outline.count));
  auto place = hn::Iota(d, 0);
  for (std::size_t i = 0; i < outline.count; i += hn::Lanes(d)) {
    const auto dx = hn::Sub(hn::LoadU(d, outline.x.data() + i), x0);
    const auto dy = hn::Sub(hn::LoadU(d, outline.y.data() + i), y0);
    visit(dx, dy, place, hn::Lt(place, count));
    place = hn::Add(place, hn::Set(d, static_cast<float>(hn::Lanes(d))));
  }
}

std::size_t FarthestFrom(const Outline& outline, std::size_t from) {
  Greatest most(-1);
  ForAll(outline, from, [&](Vector dx, Vector dy, Vector place, auto valid) HWY_ATTR {
    const auto distance = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    most.Add(hn::IfThenElse(valid, distance, hn::Set(Floats(), -1.0F)), place);
  });
  return most.Place(-1, from);
}

BothSides FarthestFromLine(const Outline& outline, std::size_t a, std::size_t b) {
  const Floats d;
  const auto ux = hn::Set(d, outline.x[b] - outline.x[a]);
  const auto uy = hn::Set(d, outline.y[b] - outline.y[a]);
  Greatest right(0);
  Greatest left(0);
  ForAll(outline, a, [&](Vector dx, Vector dy, Vector place, auto valid) HWY_ATTR {
    const auto across = hn::IfThenElseZero(valid, hn::Sub(hn::Mul(ux, dy), hn::Mul(uy, dx)));
    right.Add(across, place);
    left.Add(hn::Neg(across), place);
  });
  return {right.Place(0, a), left.Place(0, a)};
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark {

HWY_EXPORT(FarthestFrom);
HWY_EXPORT(FarthestFromLine);

std::size_t farthest_from(const Outline& outline, std::size_t from) {
  return HWY_DYNAMIC_DISPATCH(FarthestFrom)(outline, from);
}

BothSides farthest_from_line(const Outline& outline, std::size_t a, std::size_t b) {
  return HWY_DYNAMIC_DISPATCH(FarthestFromLine)(outline, a, b);
}

}  // namespace runmark
#endif
