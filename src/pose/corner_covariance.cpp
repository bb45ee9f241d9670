#include "runmark/corner_covariance.h"

#include <algorithm>
#include <cmath>

#include "corner/quad.h"
#include "pose/corner_errors.h"
#include "pose/edge_profile.h"
#include "pose/grey_sampler.h"

namespace runmark {
namespace {

double length_of(const Marker& marker, std::size_t side) {
  const Point a = marker.corners[side];
  const Point b = marker.corners[(side + 1) % 4];
  return std::hypot(b.x - a.x, b.y - a.y);
}

}  // namespace

// The numbers of both functions were fitted to some 5,000 rendered markers of 12 to 260 pixels with all sorts
// of blur, noise, tilt and compression, by their likelihood, and then scaled so that nineteen of twenty lie
// within the ellipsoid that belongs to 95 %. corner_covariance_test.cpp and docs/pose.md hold them to that
// with other markers.

CornerCovariance corner_covariance(const Marker& marker) {
  const double area = std::max(area_of(marker.corners), 1.0);
  // Cells that are not clearly black or white tell of blur.
  const double doubt = std::min(std::exp(32 * std::max(0.0, 0.5 - static_cast<double>(marker.margin))), 10.0);
  CornerErrors errors;
  for (std::size_t i = 0; i < 4; ++i) errors.sides[i] = 0.030 + 0.60 * doubt * length_of(marker, i) / area;
  errors.common = 1.5 * doubt / std::sqrt(area);
  return covariance_of(marker.corners, errors);
}

CornerCovariance corner_covariance(const Marker& marker, const ImageView& picture) {
  const double area = std::max(area_of(marker.corners), 1.0);
  const double size = std::sqrt(area);
  const GreySampler grey(picture);
  const double reach = std::clamp(size / 8, 2.0, 8.0);
  double scatter2 = 0;
  double width = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const EdgeProfile edge = edge_profile(grey, marker.corners[i], marker.corners[(i + 1) % 4], reach);
    scatter2 += edge.scatter * edge.scatter / 4;
    width += edge.width / 4;
  }
  const auto blurred = [&](double depth) { return width * std::max(0.0, width / depth - 0.0216); };
  CornerErrors errors;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = marker.corners[i];
    const Point b = marker.corners[(i + 1) % 4];
    // The detector fits a line to as many rows or columns of pixels.
    const double lines = std::clamp(0.88 * std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y)), 2.0, 24.0);
    const double by_noise = 1.62 * std::sqrt(scatter2 / lines);
    const double by_width = 0.0081 * width;
    const double by_blur = 3.4 * blurred(area / length_of(marker, i));
    errors.sides[i] = std::sqrt(by_noise * by_noise + by_width * by_width + by_blur * by_blur);
  }
  errors.common = std::min(6.0 * blurred(size), 0.4 * width);
  return covariance_of(marker.corners, errors);
}

}  // namespace runmark
