#include "pattern/cell_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace runmark {
namespace {

constexpr int most_grid = 16;  // cells across the widest marker with its neighbours
constexpr std::size_t most_samples = 64 * MarkerLayout::points_a_cell;  // a code has at most 64 bits
static_assert(most_samples % CellPoints::group == 0);
using Samples = std::array<float, most_samples>;

}  // namespace

CellReading read_cells(const GreyFrame& frame, const Homography& place, const LightModel& light,
                       const MarkerLayout& layout) {
  // Small cells are read at their middle, larger ones at a few points.
  constexpr double small_cell = 5;  // pixels
  const Point first = place(0, 0);
  const Point last = place(layout.width, layout.width);
  const double diagonal =
      std::sqrt((last.x - first.x) * (last.x - first.x) + (last.y - first.y) * (last.y - first.y));
  const bool small = diagonal < 1.41 * small_cell * layout.width;
  const CellPoints& points = small ? layout.middles : layout.spread;
  const std::size_t of_each = small ? 1 : MarkerLayout::points_a_cell;
  Samples values;  // NOLINT(*-member-init): samples fill it
  sample_cells(frame, place, points, values.data());
  light.make_relative(points, values.data());

  // Values of the data cells among their neighbours: 0 like the ring inside the square, 1 like that outside.
  const int reach = layout.overhang + 1;
  std::array<float, most_grid * most_grid> grid{};
  const auto at = [&](int x, int y) -> float& {
    return grid[static_cast<std::size_t>((y + reach) * most_grid + x + reach)];
  };
  for (int y = -reach; y < layout.width + reach; ++y) {
    for (int x = -reach; x < layout.width + reach; ++x) {
      at(x, y) = x < 0 || y < 0 || x >= layout.width || y >= layout.width ? 1.0F : 0.0F;
    }
  }
  const float* sampled = values.data();
  for (const Cell cell : layout.cells) {
    float sum = 0;
    for (std::size_t k = 0; k < of_each; ++k) sum += *sampled++;
    at(cell.x, cell.y) = sum / static_cast<float>(of_each);
  }
  // Blur mixes each cell with its neighbours: what they took is given back.
  constexpr float sharpening = 0.3F;
  CellReading reading;
  float sum = 0;
  for (const Cell cell : layout.cells) {
    const int x = cell.x;
    const int y = cell.y;
    const float value = at(x, y);
    const float neighbours = at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1);
    const float sharp = value + sharpening * (4 * value - neighbours);
    reading.code = (reading.code << 1) | (sharp > 0.5F ? 1U : 0U);
    sum += std::min(std::fabs(sharp - 0.5F), 0.5F);
  }
  reading.margin = sum / static_cast<float>(layout.cells.size());
  return reading;
}

float lightest_cell(const GreyFrame& frame, const Homography& place, const LightModel& light,
                    const MarkerLayout& layout) {
  Samples values;  // NOLINT(*-member-init): samples fill it
  sample_cells(frame, place, layout.middles, values.data());
  light.make_relative(layout.middles, values.data());
  return *std::max_element(values.data(), values.data() + layout.middles.size());
}

}  // namespace runmark
