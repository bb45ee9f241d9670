#include "pattern/pattern_picture.h"

#include "pattern/gaussian.h"

namespace runmark {
namespace {

std::array<float, 4> floats(double a, double b, double c, double d) {
  return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), static_cast<float>(d)};
}

}  // namespace

PatternCells::PatternCells(int cells_across) : width(cells_across) {
  for (int y = -rim; y < width + rim; ++y) {
    for (int x = -rim; x < width + rim; ++x) {
      at(x, y) = x < 0 || y < 0 || x >= width || y >= width ? 1.0F : 0.0F;
    }
  }
}

PatternPicture::Shares PatternPicture::at_middle(double blur) {
  const double own = step_at(0.5, blur) - step_at(-0.5, blur);
  const double rise = slope_at(0.5, blur);
  const double widening = rise / blur;
  return {floats((1 - own) / 2, own, (1 - own) / 2, 0), floats(-rise, 0, rise, 0),
          floats(widening / 2, -widening, widening / 2, 0)};
}

PatternPicture::Shares PatternPicture::at_boundary(double blur) {
  const double near = step_at(1, blur) - 0.5;
  const double rise = slope_at(0, blur);
  const double far_rise = slope_at(1, blur);
  const double widening = far_rise / blur;
  return {floats(0.5 - near, near, near, 0.5 - near),
          floats(-far_rise, far_rise - rise, rise - far_rise, far_rise),
          floats(widening, -widening, -widening, widening)};
}

// NOLINTNEXTLINE(*-member-init): the rows are filled below
PatternPicture::PatternPicture(const PatternCells& cells, double blur_along, double blur_down)
    : width_(cells.width), down_boundary_(at_boundary(blur_down)), down_middle_(at_middle(blur_down)) {
  const Shares boundary = at_boundary(blur_along);
  const Shares middle = at_middle(blur_along);
  const auto add = [](const float* cell, const std::array<float, 4>& share, int count, float* out) {
    for (int i = 0; i < count; ++i) {
      out[i] = share[0] * cell[i] + share[1] * cell[i + 1] + share[2] * cell[i + 2] + share[3] * cell[i + 3];
    }
  };
  for (int y = -PatternCells::rim; y < width_ + PatternCells::rim; ++y) {
    const float* first = cells.row(y);
    const auto line = static_cast<std::size_t>(y + PatternCells::rim);
    const auto both = [&](auto share, Rows& rows) {
      add(first, boundary.*share, width_ + 1, rows[line].data());
      add(first + 1, middle.*share, width_, rows[line].data() + width_ + 1);
    };
    both(&Shares::value, value_);
    both(&Shares::slope, along_);
    both(&Shares::by_blur, by_blur_);
  }
}

void PatternPicture::row(int place, Row& places) const {
  const bool middle = place > width_;
  const Shares& shares = middle ? down_middle_ : down_boundary_;
  const auto first = static_cast<std::size_t>(middle ? place - width_ : place);
  const int count = 2 * width_ + 1;
  const auto add = [&](const Rows& rows, const std::array<float, 4>& share, Places& out) {
    const float* a = rows[first].data();
    const float* b = rows[first + 1].data();
    const float* c = rows[first + 2].data();
    const float* d = rows[first + 3].data();
    float* sum = out.data();
    for (int i = 0; i < count; ++i)
      sum[i] = share[0] * a[i] + share[1] * b[i] + share[2] * c[i] + share[3] * d[i];
  };
  add(value_, shares.value, places.value);
  add(along_, shares.value, places.along);
  add(value_, shares.slope, places.down);
  add(by_blur_, shares.value, places.by_blur_along);
  add(value_, shares.by_blur, places.by_blur_down);
}

CellPoints picture_places(int width) {
  CellPoints points;
  for (int y = 0; y <= 2 * width; ++y) {
    for (int x = 0; x <= 2 * width; ++x) points.add(place_at(x, width), place_at(y, width));
  }
  return points;
}

}  // namespace runmark
