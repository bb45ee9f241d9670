#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "runmark/export.h"
#include "runmark/marker.h"
#include "runmark/point3.h"

namespace runmark {

/// How a lens bends the picture, as OpenCV and ROS have it.
enum class Lens : std::uint8_t {
  plain,     ///< k1 k2 p1 p2 k3 (ROS: plumb_bob)
  rational,  ///< k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 (ROS: rational_polynomial)
  fisheye,   ///< k1 k2 k3 k4 of OpenCV's fisheye module (ROS: equidistant)
};

/// The number of coefficients a lens may have.
[[nodiscard]] constexpr int coefficients_of(Lens lens) {
  return lens == Lens::plain ? 5 : lens == Lens::rational ? 12 : 4;
}

/// A calibrated camera. Lengths are in pixels; the centre of the top-left pixel is (0, 0).
struct Camera {
  int width = 0;  ///< of the pictures it was calibrated with; 0 when not known
  int height = 0;
  double fx = 0;  ///< focal length along a row, and along a column
  double fy = 0;
  double cx = 0;  ///< where the optical axis meets the picture
  double cy = 0;
  Lens lens = Lens::plain;
  std::array<double, 12> distortion{};  ///< as many as coefficients_of(lens), in OpenCV's order; then 0

  /// The picture of a point of the camera's frame; nothing for one that is not before the camera.
  [[nodiscard]] RUNMARK_EXPORT std::optional<Point> project(const Point3& point) const;

  /// The direction in which the camera sees a pixel, as the point with z = 1; nothing where the lens model
  /// has no such direction, as far outside the picture.
  [[nodiscard]] RUNMARK_EXPORT std::optional<Point> direction(Point pixel) const;

  /// Whether all numbers are finite, the focal lengths positive and the size not negative.
  [[nodiscard]] RUNMARK_EXPORT bool is_valid() const;
};

}  // namespace runmark
