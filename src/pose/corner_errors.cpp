#include "pose/corner_errors.h"

#include <algorithm>
#include <cmath>

namespace runmark {
namespace {

struct Vector {
  double x = 0;
  double y = 0;
};

/// How the corner moves when the line with unit normal `a` moves by one along it and the other stays: across
/// the other line's normal `b`.
Vector move_of(Vector a, Vector b) {
  constexpr double least_sine = 0.05;
  double sine = a.x * b.y - a.y * b.x;
  sine = std::copysign(std::max(std::fabs(sine), least_sine), sine);
  return {b.y / sine, -b.x / sine};
}

}  // namespace

CornerCovariance covariance_of(const std::array<Point, 4>& corners, const CornerErrors& errors) {
  // A line through evenly spread points of which the outermost 6 % at either end are left out: its variance
  // at its ends, and the covariance of the two, in units of that at its middle.
  constexpr double used = 0.88;
  constexpr double at_end = 1 + 3 / (used * used);
  constexpr double floor = 0.002;  // pixels
  constexpr double of_both_ends = 1 - 3 / (used * used);

  std::array<Vector, 4> normals;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % 4];
    const double length = std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-9);
    normals[i] = {(b.y - a.y) / length, -(b.x - a.x) / length};
  }
  CornerCovariance covariance{};
  const auto add = [&](std::size_t i, Vector a, std::size_t j, Vector b, double variance) {
    covariance[8 * (2 * i) + 2 * j] += variance * a.x * b.x;
    covariance[8 * (2 * i) + 2 * j + 1] += variance * a.x * b.y;
    covariance[8 * (2 * i + 1) + 2 * j] += variance * a.y * b.x;
    covariance[8 * (2 * i + 1) + 2 * j + 1] += variance * a.y * b.y;
  };
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t next = (side + 1) % 4;
    const Vector at_start = move_of(normals[side], normals[(side + 3) % 4]);
    const Vector at_finish = move_of(normals[side], normals[next]);
    const double variance = errors.sides[side] * errors.sides[side];
    add(side, at_start, side, at_start, at_end * variance);
    add(next, at_finish, next, at_finish, at_end * variance);
    add(side, at_start, next, at_finish, of_both_ends * variance);
    add(next, at_finish, side, at_start, of_both_ends * variance);
  }
  std::array<double, 8> outwards{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4;
    const Vector by_side = move_of(normals[i], normals[before]);
    const Vector by_other = move_of(normals[before], normals[i]);
    outwards[2 * i] = errors.common * (by_side.x + by_other.x);
    outwards[2 * i + 1] = errors.common * (by_side.y + by_other.y);
  }
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < 8; ++j) covariance[8 * i + j] += outwards[i] * outwards[j];
  }
  for (std::size_t i = 0; i < 8; ++i) covariance[9 * i] += floor * floor;
  return covariance;
}

}  // namespace runmark
