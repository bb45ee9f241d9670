#include "pattern/cell_samples.h"

#include <algorithm>
#include <cstdint>

// Each point's sums are its own, so all vector extensions give the same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pattern/cell_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, CellPoints::group>;
using Ints = hn::RebindToSigned<Floats>;

/// Points worked on together, so that few wait for one another.
constexpr std::size_t most_points = 8 * CellPoints::group;

/// Where points lie: the pixel up and left of each, and how far beyond its centre.
struct PixelPlaces {
  alignas(64) std::int32_t x[most_points];
  alignas(64) std::int32_t y[most_points];
  alignas(64) float fx[most_points];
  alignas(64) float fy[most_points];
};

/// The four pixels round each point: the left one in the lower byte, the right one in the next.
struct PixelSquares {
  alignas(64) std::int32_t upper[most_points];
  alignas(64) std::int32_t lower[most_points];
};

/// The last pixel of `size` that has one after it.
HWY_INLINE int LastPair(int size) { return std::max(size - 2, 0); }

template <class V>
HWY_INLINE void SplitPixel(V position, int size, std::int32_t* pixel, float* fraction) {
  const Floats d;
  const Ints ints;
  const auto inside =
      hn::Min(hn::Max(position, hn::Zero(d)), hn::Set(d, static_cast<float>(std::max(size - 1, 0))));
  const auto whole =
      hn::Min(hn::Max(hn::ConvertTo(ints, inside), hn::Zero(ints)), hn::Set(ints, LastPair(size)));
  hn::Store(whole, ints, pixel);
  hn::Store(hn::Sub(inside, hn::ConvertTo(d, whole)), d, fraction);
}

HWY_INLINE void Place(const GreyFrame& frame, const Homography& place, const float* u, const float* v,
                      std::size_t count, PixelPlaces& places) {
  const Floats d;
  const auto at = [&](double coefficient) HWY_ATTR { return hn::Set(d, static_cast<float>(coefficient)); };
  const Homography::Coefficients& h = place.coefficients();
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto cell_u = hn::Load(d, u + i);
    const auto cell_v = hn::Load(d, v + i);
    const auto of = [&](double along_u, double along_v, double constant) HWY_ATTR {
      return hn::Add(hn::Add(hn::Mul(at(along_u), cell_u), hn::Mul(at(along_v), cell_v)), at(constant));
    };
    const auto weight = of(h.g, h.h, 1);
    SplitPixel(hn::Div(of(h.xu, h.xv, h.x0), weight), frame.width, places.x + i, places.fx + i);
    SplitPixel(hn::Div(of(h.yu, h.yv, h.y0), weight), frame.height, places.y + i, places.fy + i);
  }
}

/// @param pair_at  of a row, the grey levels of the pixel so many after the first and of the next one
template <class PairAt>
HWY_INLINE void Collect(const GreyFrame& frame, const PixelPlaces& places, std::size_t count,
                        PixelSquares& squares, PairAt&& pair_at) {
  const int down = frame.height > 1 ? 1 : 0;
  for (std::size_t i = 0; i < count; ++i) {
    squares.upper[i] = pair_at(frame.rows[places.y[i]], places.x[i]);
    squares.lower[i] = pair_at(frame.rows[places.y[i] + down], places.x[i]);
  }
}

void SampleCells(const GreyFrame& frame, const Homography& place, const CellPoints& points, float* grey) {
  const Floats d;
  const Ints ints;
  const int right = frame.width > 1 ? 1 : 0;
  const auto between = [](auto share, auto a, auto b)
                           HWY_ATTR { return hn::Add(a, hn::Mul(share, hn::Sub(b, a))); };
  PixelPlaces places;    // NOLINT(*-member-init): filled for each group
  PixelSquares squares;  // NOLINT(*-member-init)
  alignas(64) float u[most_points];
  alignas(64) float v[most_points];
  for (std::size_t first = 0; first < points.size(); first += most_points) {
    // The last group is filled up with its last point.
    const std::size_t left = std::min(points.size() - first, most_points);
    const std::size_t count = (left + CellPoints::group - 1) / CellPoints::group * CellPoints::group;
    std::copy_n(points.u.data() + first, left, u);
    std::copy_n(points.v.data() + first, left, v);
    std::fill(u + left, u + count, u[left - 1]);
    std::fill(v + left, v + count, v[left - 1]);
    Place(frame, place, u, v, count, places);
    if (frame.format == PixelFormat::grey && frame.step == 1 && right == 1) {
      Collect(frame, places, count, squares,
              [](const std::uint8_t* row, int x) HWY_ATTR { return row[x] | row[x + 1] << 8; });
    } else {
      Collect(frame, places, count, squares, [&](const std::uint8_t* row, int x) HWY_ATTR {
        const auto at = [&](int pixel) {
          return grey_of(row + static_cast<std::ptrdiff_t>(pixel) * frame.step, frame.format);
        };
        return at(x) | at(x + right) << 8;
      });
    }
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      const auto fx = hn::Load(d, places.fx + i);
      const auto along = [&](const std::int32_t* pairs) HWY_ATTR {
        const auto both = hn::Load(ints, pairs + i);
        return between(fx, hn::ConvertTo(d, hn::And(both, hn::Set(ints, 0xFF))),
                       hn::ConvertTo(d, hn::ShiftRight<8>(both)));
      };
      const auto upper = along(squares.upper);
      const auto lower = along(squares.lower);
      hn::StoreU(between(hn::Load(d, places.fy + i), upper, lower), d, grey + first + i);
    }
  }
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark {

HWY_EXPORT(SampleCells);

void sample_cells(const GreyFrame& frame, const Homography& place, const CellPoints& points, float* grey) {
  HWY_DYNAMIC_DISPATCH(SampleCells)(frame, place, points, grey);
}

}  // namespace runmark
#endif
