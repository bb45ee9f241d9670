#pragma once

namespace runmark {

/// exp(-t) for t >= 0 to ten digits, by sums, products and a quotient only: the same bits on every machine,
/// which the standard library's does not promise.
[[nodiscard]] constexpr double decay(double t) {
  constexpr double nothing = 50;
  if (t > nothing) return 0;
  const double x = t / 64;
  double power = 1;
  for (int term = 10; term >= 1; --term) power = 1 + power * x / term;
  for (int square = 0; square < 6; ++square) power *= power;
  return 1 / power;
}

/// How fast a step blurred by a Gaussian of standard deviation `blur` rises, a distance after it.
[[nodiscard]] constexpr double slope_at(double distance, double blur) {
  constexpr double root_of_two_pi = 2.5066282746310002;
  const double x = distance / blur;
  return decay(x * x / 2) / (blur * root_of_two_pi);
}

/// The share of the step's light that has come in there, within 2e-7 (Abramowitz and Stegun, "Handbook of
/// Mathematical Functions", 7.1.26).
[[nodiscard]] constexpr double step_at(double distance, double blur) {
  constexpr double root_of_two = 1.4142135623730951;
  const double x = (distance < 0 ? -distance : distance) / (blur * root_of_two);
  const double t = 1 / (1 + 0.3275911 * x);
  const double sum =
      t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  const double beyond = sum * decay(x * x) / 2;
  return distance < 0 ? beyond : 1 - beyond;
}

}  // namespace runmark
