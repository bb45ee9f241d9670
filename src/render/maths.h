#pragma once

namespace runmark::render {

// Elementary functions out of + - * / alone. The C library's differ in the last bit from one machine to
// the next, and one bit is enough to round a grey level the other way.

inline constexpr double pi = 3.14159265358979323846;

/// For |x| below about 1e6; error below 1e-15.
[[nodiscard]] double sine(double x);
[[nodiscard]] double cosine(double x);

/// Relative error below 1e-14 for |x| below 700.
[[nodiscard]] double exponential(double x);

/// For x > 0.
[[nodiscard]] double logarithm(double x);

/// x to the power y for x >= 0.
[[nodiscard]] double power(double x, double y);

[[nodiscard]] constexpr double radians(double degrees) { return degrees * (pi / 180); }

}  // namespace runmark::render
