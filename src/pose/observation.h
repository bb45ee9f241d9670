#pragma once

#include <opencv2/core/matx.hpp>
#include <vector>

#include "runmark/camera.h"
#include "runmark/corner_covariance.h"

namespace runmark {

/// Points that were seen, in groups whose errors belong together: a marker's four corners, or one point.
struct Observation {
  struct Group {
    int points = 1;  ///< 1 or 4
    cv::Matx<double, 8, 8>
        whitener;  ///< takes the offsets of the group's points to independent ones of deviation 1
  };
  std::vector<Point3> object;  ///< in the object's frame
  std::vector<Point> image;    ///< pixels
  std::vector<Group> groups;   ///< in the order of the points

  /// @param object_corners  where the marker's corners are
  /// False when the covariance is not one.
  [[nodiscard]] bool add_marker(const std::array<Point3, 4>& object_corners,
                                const std::array<Point, 4>& corners, const CornerCovariance& covariance);
  /// @param deviation  of x and of y, in pixels; positive
  void add_point(const Point3& object_point, Point place, double deviation);
};

}  // namespace runmark
