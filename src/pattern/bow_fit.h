#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace runmark {

/// A side's edge relative to the straight line from corner to corner: its offset at t from 0 to 1 is
/// a + b (t - 1/2) + c (t - 1/2)^2. A lens bows long sides.
struct Bow {
  double a = 0;
  double b = 0;
  double c = 0;
  [[nodiscard]] double at(double t) const { return a + (b + c * (t - 0.5)) * (t - 0.5); }
  [[nodiscard]] double slope(double t) const { return b + 2 * c * (t - 0.5); }
};

/// Weighted least squares of a Bow through offsets, in moments.
class BowFit {
 public:
  /// `sum` is the weight times the offset.
  void add(double t, double weight, double sum) {
    const double x = t - 0.5;
    x_[0] += weight;
    x_[1] += weight * x;
    x_[2] += weight * x * x;
    x_[3] += weight * x * x * x;
    x_[4] += weight * x * x * x * x;
    y_[0] += sum;
    y_[1] += sum * x;
    y_[2] += sum * x * x;
    yy_ += sum * sum / weight;
  }

  [[nodiscard]] Bow straight() const {
    const double det = x_[0] * x_[2] - x_[1] * x_[1];
    if (det <= 0) return {y_[0] / x_[0], 0, 0};
    return {(y_[0] * x_[2] - y_[1] * x_[1]) / det, (x_[0] * y_[1] - x_[1] * y_[0]) / det, 0};
  }

  /// The parabola where it explains the offsets far better than the line does, else the line.
  [[nodiscard]] Bow bow(int offsets) const {
    constexpr int least_offsets = 12;
    constexpr double clearly_better = 10;
    const Bow line = straight();
    if (offsets < least_offsets) return line;
    const double m00 = x_[2] * x_[4] - x_[3] * x_[3];
    const double m01 = x_[2] * x_[3] - x_[1] * x_[4];
    const double m02 = x_[1] * x_[3] - x_[2] * x_[2];
    const double m11 = x_[0] * x_[4] - x_[2] * x_[2];
    const double m12 = x_[1] * x_[2] - x_[0] * x_[3];
    const double m22 = x_[0] * x_[2] - x_[1] * x_[1];
    const double det = x_[0] * m00 + x_[1] * m01 + x_[2] * m02;
    if (det <= 0) return line;
    const Bow curve{(m00 * y_[0] + m01 * y_[1] + m02 * y_[2]) / det,
                    (m01 * y_[0] + m11 * y_[1] + m12 * y_[2]) / det,
                    (m02 * y_[0] + m12 * y_[1] + m22 * y_[2]) / det};
    const double left = residual(curve);
    return (residual(line) - left) * (offsets - 3) > clearly_better * left ? curve : line;
  }

 private:
  [[nodiscard]] double residual(const Bow& f) const {
    return std::max(yy_ - f.a * y_[0] - f.b * y_[1] - f.c * y_[2], 1e-9 * x_[0]);
  }

  std::array<double, 5> x_{};  // sums of weight * x^k
  std::array<double, 3> y_{};  // sums of weight * offset * x^k
  double yy_ = 0;
};

}  // namespace runmark
