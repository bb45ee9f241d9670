#include "camera/lens.h"

#include <cmath>

namespace runmark {
namespace {

Bent bend_polynomial(const std::array<double, 12>& d, Point p) {
  const auto [x, y] = p;
  const double k1 = d[0];
  const double k2 = d[1];
  const double p1 = d[2];
  const double p2 = d[3];
  const double k3 = d[4];
  const double r2 = x * x + y * y;
  const double over = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double under = 1 + r2 * (d[5] + r2 * (d[6] + r2 * d[7]));
  const double scale = over / under;
  // By r2.
  const double over1 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
  const double under1 = d[5] + r2 * (2 * d[6] + r2 * 3 * d[7]);
  const double scale1 = (over1 - scale * under1) / under;
  const double prism_x = d[8] + 2 * d[9] * r2;
  const double prism_y = d[10] + 2 * d[11] * r2;
  Bent bent;
  bent.at.x = x * scale + 2 * p1 * x * y + p2 * (r2 + 2 * x * x) + r2 * (d[8] + d[9] * r2);
  bent.at.y = y * scale + 2 * p2 * x * y + p1 * (r2 + 2 * y * y) + r2 * (d[10] + d[11] * r2);
  bent.by = {scale + 2 * x * x * scale1 + 2 * p1 * y + 6 * p2 * x + 2 * x * prism_x,
             2 * x * y * scale1 + 2 * p1 * x + 2 * p2 * y + 2 * y * prism_x,
             2 * x * y * scale1 + 2 * p2 * y + 2 * p1 * x + 2 * x * prism_y,
             scale + 2 * y * y * scale1 + 2 * p2 * x + 6 * p1 * y + 2 * y * prism_y};
  return bent;
}

Bent bend_fisheye(const std::array<double, 12>& d, Point p) {
  const auto [x, y] = p;
  const double r = std::sqrt(x * x + y * y);
  if (r < 1e-9) return {p};
  const double theta = std::atan(r);
  const double t2 = theta * theta;
  const double angle = theta * (1 + t2 * (d[0] + t2 * (d[1] + t2 * (d[2] + t2 * d[3]))));
  const double angle1 = 1 + t2 * (3 * d[0] + t2 * (5 * d[1] + t2 * (7 * d[2] + t2 * 9 * d[3])));
  const double scale = angle / r;
  const double scale1 = (angle1 / (1 + r * r) - scale) / (r * r);  // by r, over r
  Bent bent;
  bent.at = {x * scale, y * scale};
  bent.by = {scale + x * x * scale1, x * y * scale1, x * y * scale1, scale + y * y * scale1};
  return bent;
}

}  // namespace

Bent bend(const Camera& camera, Point direction) {
  return camera.lens == Lens::fisheye ? bend_fisheye(camera.distortion, direction)
                                      : bend_polynomial(camera.distortion, direction);
}

}  // namespace runmark
