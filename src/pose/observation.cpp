#include "pose/observation.h"

#include <cmath>

namespace runmark {
namespace {

constexpr int coordinates = 8;

/// The inverse of the covariance's Cholesky factor; false when it is not positive definite.
bool whiten(const CornerCovariance& covariance, cv::Matx<double, 8, 8>& whitener) {
  cv::Matx<double, 8, 8> factor = cv::Matx<double, 8, 8>::zeros();
  for (int i = 0; i < coordinates; ++i) {
    for (int j = 0; j <= i; ++j) {
      double left = covariance[static_cast<std::size_t>(i * coordinates + j)];
      for (int k = 0; k < j; ++k) left -= factor(i, k) * factor(j, k);
      if (i != j) {
        factor(i, j) = left / factor(j, j);
      } else if (left > 0) {
        factor(i, i) = std::sqrt(left);
      } else {
        return false;  // also when it is not a number
      }
    }
  }
  whitener = cv::Matx<double, 8, 8>::zeros();
  for (int column = 0; column < coordinates; ++column) {
    for (int i = column; i < coordinates; ++i) {
      double left = i == column ? 1 : 0;
      for (int k = column; k < i; ++k) left -= factor(i, k) * whitener(k, column);
      whitener(i, column) = left / factor(i, i);
    }
  }
  return true;
}

}  // namespace

bool Observation::add_marker(const std::array<Point3, 4>& object_corners, const std::array<Point, 4>& corners,
                             const CornerCovariance& covariance) {
  Group group{4, {}};
  if (!whiten(covariance, group.whitener)) return false;
  groups.push_back(group);
  object.insert(object.end(), object_corners.begin(), object_corners.end());
  image.insert(image.end(), corners.begin(), corners.end());
  return true;
}

void Observation::add_point(const Point3& object_point, Point place, double deviation) {
  Group group{1, cv::Matx<double, 8, 8>::zeros()};
  group.whitener(0, 0) = group.whitener(1, 1) = 1 / deviation;
  groups.push_back(group);
  object.push_back(object_point);
  image.push_back(place);
}

}  // namespace runmark
