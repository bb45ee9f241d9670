#include "render/rasterise.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace runmark::render {

namespace {

// A pixel's corner, seen on the plane.
struct Lattice {
  double u = 0;
  double v = 0;
  bool in_front = false;
  float value = 0;  // clutter only
};

struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;  // exclusive
  int y1 = 0;
};

// The pixels a surface may touch. Its sides may be bent by the lens: several points of each are taken.
PixelBox pixel_box(const Camera& camera, const Surface& surface) {
  constexpr int steps = 8;
  double x0 = 1e9;
  double y0 = 1e9;
  double x1 = -1e9;
  double y1 = -1e9;
  const Rectangle& e = surface.extent;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double u = e.left + t * (e.right - e.left);
    const double v = e.top + t * (e.bottom - e.top);
    for (const auto& [a, b] : {std::pair{u, e.top}, {u, e.bottom}, {e.left, v}, {e.right, v}}) {
      if (surface.pose.at(a, b).z < 0.05) return {0, 0, camera.width, camera.height};
      const Point p = camera.picture(surface.pose, a, b);
      x0 = std::min(x0, p.x);
      y0 = std::min(y0, p.y);
      x1 = std::max(x1, p.x);
      y1 = std::max(y1, p.y);
    }
  }
  // The bend between two of the points is at most this.
  const double slack = 2 + 0.02 * std::abs(camera.distortion) * std::max(x1 - x0, y1 - y0);
  const auto pixel = [](double x, int limit) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(limit)));
  };
  return {pixel(x0 - slack, camera.width), pixel(y0 - slack, camera.height),
          pixel(x1 + slack + 1, camera.width), pixel(y1 + slack + 1, camera.height)};
}

template <class T>
class Painter {
 public:
  Painter(Plane& picture, const Camera& camera, const Surface& surface, const T& texture)
      : picture_(picture),
        camera_(camera),
        surface_(surface),
        texture_(texture),
        to_plane_(camera.project(surface.pose).inverse()) {}

  void run() {
    const PixelBox box = pixel_box(camera_, surface_);
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
    const auto columns = static_cast<std::size_t>(box.x1 - box.x0 + 1);
    std::vector<Lattice> above(columns);
    std::vector<Lattice> below(columns);
    fill(above, box.x0, box.y0);
    for (int y = box.y0; y < box.y1; ++y) {
      fill(below, box.x0, y + 1);
      float* row = picture_.row(y);
      for (int x = box.x0; x < box.x1; ++x) {
        const auto i = static_cast<std::size_t>(x - box.x0);
        row[x] = pixel(x, y, row[x], above[i], above[i + 1], below[i], below[i + 1]);
      }
      std::swap(above, below);
    }
  }

 private:
  static constexpr bool exact = std::is_same_v<T, MarkerPrint>;
  // Hardly any edges inside: four samples will do.
  static constexpr bool smooth = std::is_same_v<T, Gradient> || std::is_same_v<T, Noise> ||
                                 std::is_same_v<T, Wood> || std::is_same_v<T, Photo>;

  [[nodiscard]] Vec3 on_plane(double x, double y) const {
    const Point p = camera_.undistort({x, y});
    return to_plane_(p.x, p.y);
  }

  [[nodiscard]] bool inside(double u, double v) const {
    const Rectangle& e = surface_.extent;
    return u >= e.left && u < e.right && v >= e.top && v < e.bottom;
  }

  // The top corners of the pixels of row y.
  void fill(std::vector<Lattice>& corners, int x0, int y) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 p = on_plane(x0 + static_cast<int>(i) - 0.5, y - 0.5);
      corners[i] = {p.x, p.y, p.z > 0, 0};
      if constexpr (!exact) {
        if (p.z > 0 && inside(p.x, p.y)) corners[i].value = texture_.value(p.x, p.y);
      }
    }
  }

  [[nodiscard]] float pixel(int x, int y, float old, const Lattice& a, const Lattice& b, const Lattice& c,
                            const Lattice& d) const {
    if (!a.in_front && !b.in_front && !c.in_front && !d.in_front) return old;
    if (!(a.in_front && b.in_front && c.in_front && d.in_front)) return sample<8>(x, y, old);
    const double u0 = std::min({a.u, b.u, c.u, d.u});
    const double u1 = std::max({a.u, b.u, c.u, d.u});
    const double v0 = std::min({a.v, b.v, c.v, d.v});
    const double v1 = std::max({a.v, b.v, c.v, d.v});
    const Rectangle& e = surface_.extent;
    if (u1 <= e.left || u0 >= e.right || v1 <= e.top || v0 >= e.bottom) return old;
    if (u0 < e.left || u1 > e.right || v0 < e.top || v1 > e.bottom) return sample<8>(x, y, old);
    if constexpr (exact) {
      if (!texture_.plain(u0, u1, v0, v1)) return sample<8>(x, y, old);
      return surface_.shade * texture_.value((u0 + u1) / 2, (v0 + v1) / 2);
    } else {
      if constexpr (smooth) return surface_.shade * 0.25F * (a.value + b.value + c.value + d.value);
      const float low = std::min({a.value, b.value, c.value, d.value});
      const float high = std::max({a.value, b.value, c.value, d.value});
      if (high - low > 0.06F) return sample<4>(x, y, old);
      return surface_.shade * 0.25F * (a.value + b.value + c.value + d.value);
    }
  }

  template <int n>
  [[nodiscard]] float sample(int x, int y, float old) const {
    float sum = 0;
    int count = 0;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double sx = (i + (j + 0.5) / n) / n - 0.5;
        const double sy = (j + (n - 1 - i + 0.5) / n) / n - 0.5;
        const Vec3 p = on_plane(x + sx, y + sy);
        if (p.z <= 0 || !inside(p.x, p.y)) continue;
        sum += texture_.value(p.x, p.y);
        ++count;
      }
    }
    const float cover = static_cast<float>(count) / (n * n);
    return old * (1 - cover) + surface_.shade * sum / (n * n);
  }

  Plane& picture_;
  const Camera& camera_;
  const Surface& surface_;
  const T& texture_;
  Homography to_plane_;
};

}  // namespace

void paint(Plane& picture, const Camera& camera, const Surface& surface) {
  std::visit([&](const auto& texture) { Painter(picture, camera, surface, texture).run(); }, surface.texture);
}

}  // namespace runmark::render
