#include <algorithm>
#include <cmath>

#include "runmark/pose.h"

namespace runmark {

Point3 Pose::operator()(const Point3& p) const {
  const auto& r = rotation;
  return {r[0] * p.x + r[1] * p.y + r[2] * p.z + translation.x,
          r[3] * p.x + r[4] * p.y + r[5] * p.z + translation.y,
          r[6] * p.x + r[7] * p.y + r[8] * p.z + translation.z};
}

Pose Pose::inverse() const {
  const auto& r = rotation;
  Pose back{{r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]}, {}};
  const Point3 t = back(translation);
  back.translation = {-t.x, -t.y, -t.z};
  return back;
}

Pose operator*(const Pose& outer, const Pose& inner) {
  Pose both;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += outer.rotation[3 * row + k] * inner.rotation[3 * k + column];
      both.rotation[3 * row + column] = sum;
    }
  }
  both.translation = outer(inner.translation);
  return both;
}

std::array<double, 4> quaternion(const Pose& pose) {
  const auto& r = pose.rotation;
  // Four times the squares of w, x, y and z: start from the largest.
  const std::array squares{1 + r[0] + r[4] + r[8], 1 + r[0] - r[4] - r[8], 1 - r[0] + r[4] - r[8],
                           1 - r[0] - r[4] + r[8]};
  std::array<double, 4> q{};  // w, x, y, z
  switch (std::max_element(squares.begin(), squares.end()) - squares.begin()) {
    case 0:
      q = {squares[0], r[7] - r[5], r[2] - r[6], r[3] - r[1]};
      break;
    case 1:
      q = {r[7] - r[5], squares[1], r[1] + r[3], r[2] + r[6]};
      break;
    case 2:
      q = {r[2] - r[6], r[1] + r[3], squares[2], r[5] + r[7]};
      break;
    default:
      q = {r[3] - r[1], r[2] + r[6], r[5] + r[7], squares[3]};
  }
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double scale = (q[0] < 0 ? -1 : 1) / length;
  return {q[1] * scale, q[2] * scale, q[3] * scale, q[0] * scale};
}

Point3 rotation_vector(const Pose& pose) {
  const auto [x, y, z, w] = quaternion(pose);
  const double sine = std::sqrt(x * x + y * y + z * z);
  const double scale = sine > 1e-12 ? 2 * std::atan2(sine, w) / sine : 2;
  return {x * scale, y * scale, z * scale};
}

Pose pose_from(const Point3& v, const Point3& translation) {
  const double angle = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const double half = angle / 2;
  const double scale = angle > 1e-12 ? std::sin(half) / angle : 0.5;
  const double x = v.x * scale;
  const double y = v.y * scale;
  const double z = v.z * scale;
  const double w = std::cos(half);
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
           2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),  //
           2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)},
          translation};
}

}  // namespace runmark
