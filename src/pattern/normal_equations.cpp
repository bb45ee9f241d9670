#include "pattern/normal_equations.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pattern/normal_equations.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace runmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Equations = runmark::NormalEquations;

/// Products are not fused with sums: not every extension can.
void AddObservations(const Equations::Observation* observations, std::size_t count, float* sums) {
  const hn::CappedTag<float, Equations::Observation::size> d;
  constexpr std::size_t size = Equations::Observation::size;
  for (std::size_t first = 0; first < size; first += hn::Lanes(d)) {
    hn::Vec<decltype(d)> sum[Equations::parameters];
    for (std::size_t i = 0; i < Equations::parameters; ++i) sum[i] = hn::LoadU(d, sums + i * size + first);
    for (std::size_t n = 0; n < count; ++n) {
      const auto values = hn::LoadU(d, observations[n].values.data() + first);
      const float* weighted = observations[n].weighted.data();
#pragma GCC unroll 12
      for (std::size_t i = 0; i < Equations::parameters; ++i) {
        sum[i] = hn::Add(sum[i], hn::Mul(hn::Set(d, weighted[i]), values));
      }
    }
    for (std::size_t i = 0; i < Equations::parameters; ++i) hn::StoreU(sum[i], d, sums + i * size + first);
  }
}

}  // namespace runmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace runmark {

HWY_EXPORT(AddObservations);

void NormalEquations::add(const Observation* observations, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(AddObservations)(observations, count, sums_[0].data());
}

bool NormalEquations::solve(Step& step) const {
  constexpr double least_pivot = 1e-6;
  std::array<Step, parameters> factor{};
  for (std::size_t i = 0; i < parameters; ++i) {
    step[i] = static_cast<double>(sums_[i][Observation::rest]);
    for (std::size_t j = 0; j < i; ++j) {
      double left = static_cast<double>(sums_[i][j]);
      for (std::size_t k = 0; k < j; ++k) left -= factor[i][k] * factor[j][k];
      factor[i][j] = left * factor[j][j];
      step[i] -= factor[i][j] * step[j];
    }
    double left = static_cast<double>(sums_[i][i]) + held_[i];
    for (std::size_t k = 0; k < i; ++k) left -= factor[i][k] * factor[i][k];
    if (!(left > least_pivot)) return false;
    factor[i][i] = 1 / std::sqrt(left);  // the diagonal is kept as its reciprocal
    step[i] *= factor[i][i];
  }
  for (std::size_t i = parameters; i-- > 0;) {
    for (std::size_t k = i + 1; k < parameters; ++k) step[i] -= factor[k][i] * step[k];
    step[i] *= factor[i][i];
  }
  return true;
}

}  // namespace runmark
#endif
