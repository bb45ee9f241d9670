#include "render/maths.h"

#include <cmath>

namespace runmark::render {

namespace {

// Taylor series on [-pi/4, pi/4]; the first term left out is below 1e-17.
double sine_near_zero(double x) {
  const double x2 = x * x;
  double term = x;
  double sum = x;
  for (int n = 2; n <= 16; n += 2) {
    term *= -x2 / (n * (n + 1));
    sum += term;
  }
  return sum;
}

double cosine_near_zero(double x) {
  const double x2 = x * x;
  double term = 1;
  double sum = 1;
  for (int n = 1; n <= 17; n += 2) {
    term *= -x2 / (n * (n + 1));
    sum += term;
  }
  return sum;
}

}  // namespace

double sine(double x) {
  const double quarters = std::floor(x * (2 / pi) + 0.5);
  const double rest = x - quarters * (pi / 2);
  const auto quadrant = static_cast<long long>(quarters) & 3;
  const double value = (quadrant & 1) != 0 ? cosine_near_zero(rest) : sine_near_zero(rest);
  return quadrant >= 2 ? -value : value;
}

double cosine(double x) { return sine(x + pi / 2); }

double exponential(double x) {
  constexpr double ln2 = 0.693147180559945309417;
  const double twos = std::floor(x / ln2 + 0.5);
  const double rest = x - twos * ln2;
  double term = 1;
  double sum = 1;
  for (int n = 1; n <= 16; ++n) {
    term *= rest / n;
    sum += term;
  }
  return std::ldexp(sum, static_cast<int>(twos));
}

double logarithm(double x) {
  constexpr double ln2 = 0.693147180559945309417;
  int twos = 0;
  double m = std::frexp(x, &twos);
  if (m < 0.70710678118654752) {
    m *= 2;
    --twos;
  }
  // ln m = 2 artanh((m - 1) / (m + 1))
  const double s = (m - 1) / (m + 1);
  const double s2 = s * s;
  double term = s;
  double sum = 0;
  for (int n = 1; n <= 23; n += 2) {
    sum += term / n;
    term *= s2;
  }
  return 2 * sum + twos * ln2;
}

double power(double x, double y) { return x > 0 ? exponential(y * logarithm(x)) : 0; }

}  // namespace runmark::render
