#pragma once

#include <cmath>
#include <opencv2/core/matx.hpp>

namespace runmark {

/// The step that normal equations ask for, by Cholesky's decomposition; parameters of very different units
/// are brought to one first. False when some direction is not held. (cv::solve does the same in fifty times
/// as many instructions.)
/// @param damping  added to the diagonal of ones
template <int n>
[[nodiscard]] bool damped_step(const cv::Matx<double, n, n>& information, const cv::Vec<double, n>& gradient,
                               double damping, cv::Vec<double, n>& step) {
  constexpr double least_pivot = 1e-14;
  cv::Matx<double, n, n> factor;
  cv::Vec<double, n> scale;
  for (int i = 0; i < n; ++i) {
    if (!(information(i, i) > 0)) return false;
    scale[i] = 1 / std::sqrt(information(i, i));
  }
  for (int i = 0; i < n; ++i) {
    step[i] = gradient[i] * scale[i];
    for (int j = 0; j <= i; ++j) {
      double left = information(i, j) * scale[i] * scale[j] + (i == j ? damping : 0);
      for (int k = 0; k < j; ++k) left -= factor(i, k) * factor(j, k);
      if (i != j) {
        factor(i, j) = left / factor(j, j);
      } else if (left > least_pivot) {
        factor(i, i) = std::sqrt(left);
      } else {
        return false;
      }
    }
    for (int k = 0; k < i; ++k) step[i] -= factor(i, k) * step[k];
    step[i] /= factor(i, i);
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) step[i] -= factor(k, i) * step[k];
    step[i] /= factor(i, i);
  }
  for (int i = 0; i < n; ++i) step[i] *= scale[i];
  return true;
}

}  // namespace runmark
