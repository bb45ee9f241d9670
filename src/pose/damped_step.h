#pragma once

#include <cmath>
#include <opencv2/core.hpp>

namespace runmark {

/// The step that normal equations ask for, by Cholesky's decomposition; parameters of very different units
/// are brought to one first. False when some direction is not held.
/// @param damping  added to the diagonal of ones
template <int n>
[[nodiscard]] bool damped_step(const cv::Matx<double, n, n>& information, const cv::Vec<double, n>& gradient,
                               double damping, cv::Vec<double, n>& step) {
  cv::Matx<double, n, n> scaled = information;
  cv::Vec<double, n> scale;
  for (int i = 0; i < n; ++i) {
    if (!(information(i, i) > 0)) return false;
    scale[i] = 1 / std::sqrt(information(i, i));
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) scaled(i, j) *= scale[i] * scale[j];
    scaled(i, i) += damping;
  }
  const cv::Vec<double, n> right(gradient.mul(scale));
  if (!cv::solve(scaled, right, step, cv::DECOMP_CHOLESKY)) return false;
  step = step.mul(scale);
  return true;
}

}  // namespace runmark
