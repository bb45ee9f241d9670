#pragma once

#include <algorithm>
#include <cmath>

#include "runmark/image_view.h"
#include "threshold/grey.h"

namespace runmark {

/// Grey levels of a picture at whole and between pixels; beyond the edge the nearest pixel counts.
class GreySampler {
 public:
  explicit GreySampler(const ImageView& picture) : picture_(picture) {}

  [[nodiscard]] int width() const { return picture_.width; }
  [[nodiscard]] int height() const { return picture_.height; }

  [[nodiscard]] int at(int x, int y) const {
    x = std::clamp(x, 0, picture_.width - 1);
    y = std::clamp(y, 0, picture_.height - 1);
    return grey_of(picture_.row(y) + static_cast<std::ptrdiff_t>(x) * picture_.step, picture_.format);
  }

  /// Bilinear.
  [[nodiscard]] double between(double x, double y) const {
    x = std::clamp(x, 0.0, picture_.width - 1.0);
    y = std::clamp(y, 0.0, picture_.height - 1.0);
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const double fx = x - x0;
    const double fy = y - y0;
    return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x0 + 1, y0)) +
           fy * ((1 - fx) * at(x0, y0 + 1) + fx * at(x0 + 1, y0 + 1));
  }

 private:
  const ImageView& picture_;
};

}  // namespace runmark
