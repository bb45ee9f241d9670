#include "corner/side_cracks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "corner/side_cracks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Doubles>;

/// Sums over runs, a run a lane.
struct Sums {
  Vector n, x, y, xx, xy, yy;
  Vector level, upright;  // cubes of the lengths less the lengths
  Vector covered;
};

/// Adds what of the run between two crack points lies between `low` and `high`.
void AddCutRun(Point from, Point to, const SideWay& way, SideCracks& cracks) {
  const Point u = way.along;
  Point p{from.x - way.start.x, from.y - way.start.y};
  Point q{to.x - way.start.x, to.y - way.start.y};
  const double sp = p.x * u.x + p.y * u.y;
  const double sq = q.x * u.x + q.y * u.y;
  const double rise = sq - sp;
  const double t0 = std::clamp(((rise > 0 ? way.low : way.high) - sp) / rise, 0.0, 1.0);
  const double t1 = std::clamp(((rise > 0 ? way.high : way.low) - sp) / rise, 0.0, 1.0);
  if (t1 <= t0) return;
  const Point d{q.x - p.x, q.y - p.y};
  q = {p.x + t1 * d.x, p.y + t1 * d.y};
  p = {p.x + t0 * d.x, p.y + t0 * d.y};
  const double forward = (q.x - p.x) * u.x + (q.y - p.y) * u.y;
  const double off_p = p.x * u.y - p.y * u.x;
  const double off_q = q.x * u.y - q.y * u.x;
  if (std::fabs(off_p + off_q) > 2 * way.band || std::fabs(off_q - off_p) > std::max(way.band, forward))
    return;
  cracks.covered += forward;
  cracks.fit.add_cracks({p.x + way.start.x, p.y + way.start.y}, {q.x + way.start.x, q.y + way.start.y});
}

/// Adds the runs from vertex `from` to vertex `to`, which comes after it.
void AddStretch(const Outline& outline, std::size_t from, std::size_t to, const SideWay& way, Sums& sums,
                SideCracks& cracks) {
  const Doubles d;
  const hn::Rebind<float, Doubles> floats;
  // Vertices lie half a pixel behind crack coordinates.
  const auto x0 = hn::Set(d, way.start.x + 0.5);
  const auto y0 = hn::Set(d, way.start.y + 0.5);
  const auto ux = hn::Set(d, way.along.x);
  const auto uy = hn::Set(d, way.along.y);
  const auto low = hn::Set(d, way.low);
  const auto high = hn::Set(d, way.high);
  const auto band = hn::Set(d, way.band);
  const auto half = hn::Set(d, 0.5);
  for (std::size_t i = from; i < to; i += hn::Lanes(d)) {
    const auto load = [&](const std::vector<float>& values, std::size_t at, Vector origin) HWY_ATTR {
      return hn::Sub(hn::PromoteTo(d, hn::LoadU(floats, values.data() + at)), origin);
    };
    const auto px = load(outline.x, i, x0);
    const auto py = load(outline.y, i, y0);
    const auto qx = load(outline.x, i + 1, x0);
    const auto qy = load(outline.y, i + 1, y0);
    const auto sp = hn::Add(hn::Mul(px, ux), hn::Mul(py, uy));
    const auto sq = hn::Add(hn::Mul(qx, ux), hn::Mul(qy, uy));
    const auto nearer = hn::Min(sp, sq);
    const auto farther = hn::Max(sp, sq);
    const auto valid = hn::FirstN(d, to - i);
    const auto touches = hn::And(valid, hn::And(hn::Ge(farther, low), hn::Le(nearer, high)));
    const auto inside = hn::And(touches, hn::And(hn::Ge(nearer, low), hn::Le(farther, high)));
    const auto cut = hn::AndNot(inside, touches);
    const auto off_p = hn::Sub(hn::Mul(px, uy), hn::Mul(py, ux));
    const auto off_q = hn::Sub(hn::Mul(qx, uy), hn::Mul(qy, ux));
    const auto forward = hn::Sub(sq, sp);
    const auto close = hn::And(hn::Le(hn::Abs(hn::Add(off_p, off_q)), hn::Add(band, band)),
                               hn::Le(hn::Abs(hn::Sub(off_q, off_p)), hn::Max(band, forward)));
    const auto counts = hn::And(inside, close);
    const auto right = hn::Abs(hn::Sub(qx, px));
    const auto down = hn::Abs(hn::Sub(qy, py));
    const auto length = hn::IfThenElseZero(counts, hn::Add(right, down));
    const auto x = hn::Mul(half, hn::Sub(hn::Add(px, qx), ux));
    const auto y = hn::Mul(half, hn::Sub(hn::Add(py, qy), uy));
    const auto nx = hn::Mul(length, x);
    const auto ny = hn::Mul(length, y);
    const auto cube = hn::Sub(hn::Mul(hn::Mul(length, length), length), length);
    const auto is_level = hn::Eq(down, hn::Zero(d));
    sums.n = hn::Add(sums.n, length);
    sums.x = hn::Add(sums.x, nx);
    sums.y = hn::Add(sums.y, ny);
    sums.xx = hn::Add(sums.xx, hn::Mul(nx, x));
    sums.xy = hn::Add(sums.xy, hn::Mul(nx, y));
    sums.yy = hn::Add(sums.yy, hn::Mul(ny, y));
    sums.level = hn::Add(sums.level, hn::IfThenElseZero(is_level, cube));
    sums.upright = hn::Add(sums.upright, hn::IfThenZeroElse(is_level, cube));
    sums.covered = hn::Add(sums.covered, hn::IfThenElseZero(counts, forward));
    if (hn::AllFalse(d, cut)) continue;
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, cut, bytes);
    for (unsigned lanes = bytes[0]; lanes != 0; lanes &= lanes - 1) {
      const std::size_t at = i + static_cast<std::size_t>(std::countr_zero(lanes));
      AddCutRun(crack_point(outline, at), crack_point(outline, at + 1), way, cracks);
    }
  }
}

SideCracks CracksOfSide(const Outline& outline, std::size_t from, std::size_t to, const SideWay& way) {
  const Doubles d;
  SideCracks cracks{LineFit({way.start.x + way.along.x / 2, way.start.y + way.along.y / 2})};
  const auto none = hn::Zero(d);
  Sums sums{none, none, none, none, none, none, none, none, none};
  if (from < to) {
    AddStretch(outline, from, to, way, sums, cracks);
  } else {
    AddStretch(outline, from, outline.count, way, sums, cracks);
    AddStretch(outline, 0, to, way, sums, cracks);
  }
  const auto total = [&](Vector v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  cracks.covered += total(sums.covered);
  cracks.fit.add_moments({total(sums.n), total(sums.x), total(sums.y),
                          total(sums.xx) + total(sums.level) / 12, total(sums.xy),
                          total(sums.yy) + total(sums.upright) / 12});
  return cracks;
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark {

HWY_EXPORT(CracksOfSide);

SideCracks side_cracks(const Outline& outline, std::size_t from, std::size_t to, const SideWay& way) {
  return HWY_DYNAMIC_DISPATCH(CracksOfSide)(outline, from, to, way);
}

}  // namespace runmark
#endif
