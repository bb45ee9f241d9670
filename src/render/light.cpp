#include "render/light.h"

#include <algorithm>
#include <cmath>

#include "render/maths.h"

namespace runmark::render {

namespace {

// The shares of level, lamps, vignette and shadows, with what is constant over the picture worked out once.
class LightField {
 public:
  LightField(const Light& light, int width, int height)
      : light_(light), centre_{(width - 1) / 2.0, (height - 1) / 2.0} {
    half_width_ = width / 2.0;
    half_height_ = height / 2.0;
    for (const Shadow& s : light.shadows) {
      shadows_.push_back({s, cosine(s.direction), sine(s.direction)});
    }
  }

  [[nodiscard]] double at(Point p) const {
    const double x = (p.x - centre_.x) / half_width_;
    const double y = (p.y - centre_.y) / half_height_;
    double level = light_.level * std::max(0.05, 1 + light_.slope_x * x + light_.slope_y * y);
    for (const Lamp& lamp : light_.lamps) {
      const double dx = p.x - lamp.place.x;
      const double dy = p.y - lamp.place.y;
      level += lamp.strength / (1 + (dx * dx + dy * dy) / (lamp.reach * lamp.reach));
    }
    for (const Prepared& s : shadows_) level *= 1 - s.shadow.depth * share(s, p);
    return level * (1 - light_.vignette * 0.5 * (x * x + y * y));
  }

 private:
  struct Prepared {
    Shadow shadow;
    double normal_x;
    double normal_y;
  };

  // 0 in the light, 1 in the full shadow.
  static double share(const Prepared& s, Point p) {
    const Shadow& shadow = s.shadow;
    const double dx = p.x - shadow.place.x;
    const double dy = p.y - shadow.place.y;
    const double across = dx * s.normal_x + dy * s.normal_y;
    double depth = 0;  // distance into the shadow
    switch (shadow.shape) {
      case Shadow::Shape::edge:
        depth = across;
        break;
      case Shadow::Shape::band:
        depth = shadow.size / 2 - std::abs(across);
        break;
      case Shadow::Shape::blinds: {
        const double period = 2 * shadow.size;
        const double within = across - period * std::floor(across / period);
        depth = shadow.size / 2 - std::abs(within - shadow.size);
        break;
      }
      case Shadow::Shape::blob:
        depth = shadow.size - std::sqrt(dx * dx + dy * dy);
        break;
    }
    const double t = std::clamp(0.5 + depth / (2 * shadow.softness), 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }

  const Light& light_;
  Point centre_;
  double half_width_ = 1;
  double half_height_ = 1;
  std::vector<Prepared> shadows_;
};

}  // namespace

double Light::at(Point p, int width, int height) const { return LightField(*this, width, height).at(p); }

void shine(Plane& picture, const Light& light) {
  const LightField field(light, picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y) {
    float* row = picture.row(y);
    for (int x = 0; x < picture.width; ++x) {
      row[x] *= static_cast<float>(field.at({static_cast<double>(x), static_cast<double>(y)}));
    }
  }
}

}  // namespace runmark::render
