#pragma once

#include <array>
#include <cmath>

#include "runmark/marker.h"

namespace runmark::render {

struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};

[[nodiscard]] constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Vec3 unit(Vec3 a) { return (1 / std::sqrt(dot(a, a))) * a; }

/// A plane in the camera's frame (x right, y down, z forwards): point (u, v) of the plane is
/// origin + u * along_u + v * along_v.
struct PlanePose {
  Vec3 origin;
  Vec3 along_u;
  Vec3 along_v;
  [[nodiscard]] constexpr Vec3 at(double u, double v) const { return origin + u * along_u + v * along_v; }
};

/// A rectangle of plane coordinates.
struct Rectangle {
  double left = 0;
  double top = 0;
  double right = 1;
  double bottom = 1;
};

/// The four corners of a quadrilateral in the image, in order.
using Quad = std::array<Point, 4>;

/// Signed area, positive for corners that run clockwise in the image.
[[nodiscard]] double area(const Quad& quad);

/// Whether two convex quadrilaterals have a point in common.
[[nodiscard]] bool overlap(const Quad& a, const Quad& b);

/// A 3x3 matrix that takes a plane to another, row-major.
struct Homography {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  /// The image of (x, y) and, as the third value, its weight: not positive means behind the camera.
  [[nodiscard]] constexpr Vec3 operator()(double x, double y) const {
    const double w = m[6] * x + m[7] * y + m[8];
    return {(m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w, w};
  }
  /// The inverse, scaled so that weights of points before the camera stay positive.
  [[nodiscard]] Homography inverse() const;
};

}  // namespace runmark::render
