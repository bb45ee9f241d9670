#pragma once

#include "render/geometry.h"

namespace runmark::render {

/// A pinhole camera and its lens. Distortion is radial, by the division model: a point at distance r from
/// the centre belongs at r / (1 + distortion * (r / reach)^2), where reach is half the image's diagonal.
/// Both directions have a closed form, so the truth is exact. Negative values are barrels.
/// Source: A. Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens
/// distortion", CVPR 2001.
struct Camera {
  int width = 640;
  int height = 480;
  double focal = 640;     ///< pixels
  double distortion = 0;  ///< at least -0.5, at most 0.2

  [[nodiscard]] constexpr double centre_x() const { return (width - 1) / 2.0; }
  [[nodiscard]] constexpr double centre_y() const { return (height - 1) / 2.0; }
  /// Half the diagonal, squared.
  [[nodiscard]] constexpr double reach2() const {
    return (static_cast<double>(width) * width + static_cast<double>(height) * height) / 4;
  }

  /// Where a point of the picture would be without distortion.
  [[nodiscard]] constexpr Point undistort(Point p) const {
    const double dx = p.x - centre_x();
    const double dy = p.y - centre_y();
    const double scale = 1 / (1 + distortion * ((dx * dx + dy * dy) / reach2()));
    return {centre_x() + dx * scale, centre_y() + dy * scale};
  }
  /// The other way round.
  [[nodiscard]] Point distort(Point p) const;

  /// The direction in which the camera sees a point of the picture; z is 1.
  [[nodiscard]] constexpr Vec3 ray(Point p) const {
    const Point q = undistort(p);
    return {(q.x - centre_x()) / focal, (q.y - centre_y()) / focal, 1};
  }
  /// From plane coordinates to the picture before distortion.
  [[nodiscard]] Homography project(const PlanePose& pose) const;
  /// The picture of a plane's point, distortion included; the point must lie before the camera.
  [[nodiscard]] Point picture(const PlanePose& pose, double u, double v) const;
  /// The picture of a rectangle's corners: left-top, right-top, right-bottom, left-bottom.
  [[nodiscard]] Quad picture(const PlanePose& pose, const Rectangle& r) const;
};

}  // namespace runmark::render
