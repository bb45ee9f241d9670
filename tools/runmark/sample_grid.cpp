#include "sample_grid.h"

#include <algorithm>
#include <cmath>

#include "pattern/grey_frame.h"
#include "pattern/homography.h"
#include "pattern/light_model.h"
#include "pattern/square_grid.h"

namespace runmark::cli {
namespace {

// A quarter of the border may be amiss: also a candidate that is no marker is worth a look.
constexpr int least_border = 4;

CrackPoint crack_at(Point p) {
  return {static_cast<int>(std::lround(p.x + 0.5)), static_cast<int>(std::lround(p.y + 0.5))};
}

}  // namespace

std::optional<SampleGrid> paper_grid(const cv::Mat& grey, const Quad& quad, const FixedThreshold& threshold) {
  const Point a = quad.corners[0];
  const Point b = quad.corners[1];
  const Point u{b.x - a.x, b.y - a.y};
  SampleGrid grid;
  grid.width = grid_side;
  grid.outline = {a, b, Point{b.x - u.y, b.y + u.x}, Point{a.x - u.y, a.y + u.x}};
  for (int row = 0; row < grid_side; ++row) {
    for (int column = 0; column < grid_side; ++column) {
      const PixelPosition p = grid_sample(crack_at(a), crack_at(b), column, row);
      if (p.x < 0 || p.y < 0 || p.x >= grey.cols || p.y >= grey.rows) return std::nullopt;
      grid.samples.push_back({{static_cast<double>(p.x), static_cast<double>(p.y)},
                              !threshold.dark(grey.at<std::uint8_t>(p.y, p.x))});
    }
  }
  return grid;
}

std::optional<SampleGrid> cell_grid(const cv::Mat& grey, const Quad& quad, const Dictionary& dictionary) {
  std::vector<const std::uint8_t*> rows;
  for (int y = 0; y < grey.rows; ++y) rows.push_back(grey.ptr(y));
  const GreyFrame frame{rows.data(), grey.cols, grey.rows};
  const Homography place(quad.corners, dictionary.width);
  const std::optional<LightModel> light =
      fit_light(frame, place, BorderRings(dictionary.width), quad.light_inside, least_border);
  if (!light) return std::nullopt;

  std::vector<Cell> cells;
  for (int y = 0; y < dictionary.width; ++y) {
    for (int x = 0; x < dictionary.width; ++x) {
      cells.push_back({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y)});
    }
  }
  std::ranges::copy_if(dictionary.cells, std::back_inserter(cells), [&](Cell cell) {
    return cell.x < 0 || cell.y < 0 || cell.x >= dictionary.width || cell.y >= dictionary.width;
  });
  SampleGrid grid;
  grid.width = dictionary.width;
  grid.outline = quad.corners;
  for (const Cell cell : cells) {
    const double u = cell.x + 0.5;
    const double v = cell.y + 0.5;
    const Point at = place(u, v);
    const auto level = static_cast<double>(frame.sample(static_cast<float>(at.x), static_cast<float>(at.y)));
    const double halfway = (light->inside.at(u, v) + light->outside.at(u, v)) / 2;
    grid.samples.push_back({at, level > halfway});
  }
  return grid;
}

}  // namespace runmark::cli
