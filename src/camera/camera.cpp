#include "runmark/camera.h"

#include <algorithm>
#include <cmath>

#include "camera/lens.h"
#include "camera/point_distance.h"

namespace runmark {
namespace {

/// Where the lens bends `from`, looked for from `start` on.
std::optional<Point> unbend(const Camera& camera, Point from, Point start) {
  constexpr int most_steps = 50;
  constexpr double close = 1e-13;
  Point p = start;
  Bent bent = bend(camera, p);
  for (int step = 0; step < most_steps; ++step) {
    const double left = distance(bent.at, from);
    if (left < close) return p;
    const auto [a, b, c, d] = bent.by;
    const double det = a * d - b * c;
    if (!(det > 0)) return {};  // beyond the fold of the model, where pictures repeat
    const Point full{(d * (from.x - bent.at.x) - b * (from.y - bent.at.y)) / det,
                     (a * (from.y - bent.at.y) - c * (from.x - bent.at.x)) / det};
    // Newton's step, shortened until it helps.
    double share = 1;
    Point next;
    for (;; share /= 2) {
      next = {p.x + share * full.x, p.y + share * full.y};
      bent = bend(camera, next);
      if (distance(bent.at, from) < left) break;
      if (share < 1e-3) return left < 1e-9 ? std::optional(p) : std::nullopt;
    }
    p = next;
  }
  return distance(bent.at, from) < 1e-9 ? std::optional(p) : std::nullopt;
}

}  // namespace

std::optional<Point> Camera::project(const Point3& point) const {
  if (!(point.z > 0)) return {};
  const Point bent = bend(*this, {point.x / point.z, point.y / point.z}).at;
  return Point{cx + fx * bent.x, cy + fy * bent.y};
}

std::optional<Point> Camera::direction(Point pixel) const {
  const Point bent{(pixel.x - cx) / fx, (pixel.y - cy) / fy};
  Point start = bent;
  if (lens == Lens::fisheye) {
    // Without coefficients the distance from the centre is the angle; keep clear of the right angle.
    const double angle = std::hypot(bent.x, bent.y);
    const double scale = angle > 0 ? std::tan(std::min(angle, 1.5)) / angle : 1;
    start = {bent.x * scale, bent.y * scale};
  }
  if (const std::optional<Point> found = unbend(*this, bent, start)) return found;
  // A strong lens: from the centre outwards no fold is in the way.
  return unbend(*this, bent, {0, 0});
}

bool Camera::is_valid() const {
  const auto finite = [](double v) { return std::isfinite(v); };
  return width >= 0 && height >= 0 && finite(fx) && finite(fy) && finite(cx) && finite(cy) && fx > 0 &&
         fy > 0 && std::all_of(distortion.begin(), distortion.end(), finite);
}

}  // namespace runmark
