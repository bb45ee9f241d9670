#include "stage_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "annotate.h"

namespace runmark::cli {
namespace {

constexpr int fraction_bits = 4;

// Far apart on a white ground, also for most colour-blind eyes (Okabe and Ito's set without yellow), in BGR.
const std::array<cv::Scalar, 6> line_colours{cv::Scalar(178, 114, 0), cv::Scalar(0, 94, 213),
                                             cv::Scalar(115, 158, 0), cv::Scalar(167, 121, 204),
                                             cv::Scalar(0, 159, 230), cv::Scalar(0, 0, 0)};
const cv::Scalar removed_colour(60, 60, 255);
const cv::Scalar added_colour(255, 120, 0);

cv::Point fixed(Point p, double zoom = 1) {
  // Pixel centres are whole numbers, so enlarging shifts by half a pixel.
  const auto place = [zoom](double c) {
    return static_cast<int>(std::lround(((c + 0.5) * zoom - 0.5) * (1 << fraction_bits)));
  };
  return {place(p.x), place(p.y)};
}

template <class Points>
void draw_polygon(cv::Mat& picture, const Points& corners, const cv::Scalar& colour, int width,
                  double zoom = 1) {
  std::vector<cv::Point> points;
  std::ranges::transform(corners, std::back_inserter(points), [zoom](Point p) { return fixed(p, zoom); });
  cv::polylines(picture, points, true, colour, width, cv::LINE_AA, fraction_bits);
}

void draw_dot(cv::Mat& picture, Point p, double radius, const cv::Scalar& colour, double zoom = 1) {
  cv::circle(picture, fixed(p, zoom), static_cast<int>(radius * (1 << fraction_bits)), colour, cv::FILLED,
             cv::LINE_AA, fraction_bits);
}

cv::Mat in_colour(const cv::Mat& picture) {
  cv::Mat result;
  if (picture.channels() == 3) return picture.clone();
  cv::cvtColor(picture, result, cv::COLOR_GRAY2BGR);
  return result;
}

/// A ground on which drawn lines stand out.
cv::Mat faded(const cv::Mat& grey) {
  cv::Mat pale;
  grey.convertTo(pale, CV_8U, 0.35, 165);
  return in_colour(pale);
}

int line_width(const cv::Mat& picture) { return std::max(1, std::min(picture.cols, picture.rows) / 400); }

std::string scale_suffix(int scale) { return scale == 1 ? "" : "-half-" + std::to_string(scale); }
std::string scale_words(int scale) { return scale == 1 ? "" : " at 1/" + std::to_string(scale) + " size"; }

/// White and black with what preprocessing changed in red (now light) and blue (now dark).
StagePicture draw_preprocess(const ScaleTrace& scale) {
  cv::Mat picture = in_colour(scale.preprocessed);
  const cv::Mat removed = scale.preprocessed > scale.thresholded;
  const cv::Mat added = scale.preprocessed < scale.thresholded;
  picture.setTo(removed_colour, removed);
  picture.setTo(added_colour, added);
  const int changed = cv::countNonZero(removed) + cv::countNonZero(added);
  return {"3-preprocess" + scale_suffix(scale.scale),
          "preprocess" + scale_words(scale.scale) + ": " + std::to_string(changed) + " pixels changed, " +
              std::to_string(scale.crack_runs) + " crack runs",
          picture, scale.scale == 1};
}

StagePicture draw_contours(const StageTrace& trace) {
  cv::Mat picture(trace.grey.size(), CV_8UC3, cv::Scalar::all(255));
  std::size_t count = 0;
  std::uint64_t closed = 0;
  for (const ScaleTrace& scale : trace.scales) {
    closed += scale.closed;
    for (const TracedContour& contour : scale.contours) {
      draw_polygon(picture, contour.corners, line_colours[count++ % line_colours.size()],
                   line_width(picture));
    }
  }
  return {"4-contours",
          "contour: " + std::to_string(closed) + " closed, " + std::to_string(count) + " handed on", picture};
}

StagePicture draw_corners(const StageTrace& trace) {
  cv::Mat picture = faded(trace.grey);
  const int width = line_width(picture);
  std::size_t count = 0;
  for (const ScaleTrace& scale : trace.scales) {
    for (const Quad& quad : scale.quads) {
      draw_polygon(picture, quad.corners, line_colours[1], width);
      for (const Point& corner : quad.corners) draw_dot(picture, corner, 1.0 + 1.5 * width, line_colours[0]);
      ++count;
    }
  }
  return {"5-corners", "corner: " + std::to_string(count) + " quadrilaterals", picture};
}

/// A marker enlarged (or made smaller) into a square, with the lines between its cells and the samples.
cv::Mat draw_grid(const cv::Mat& picture, const SampleGrid& grid, int side) {
  double left = picture.cols, right = 0, top = picture.rows, bottom = 0;
  const auto include = [&](Point p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  };
  for (const Point& corner : grid.outline) include(corner);
  for (const SampleGrid::Sample& sample : grid.samples) include(sample.at);
  const int cut = static_cast<int>(std::ceil(1.3 * std::max(right - left, bottom - top))) + 2;
  const cv::Rect wanted(static_cast<int>((left + right) / 2) - cut / 2,
                        static_cast<int>((top + bottom) / 2) - cut / 2, cut, cut);
  const cv::Rect there = wanted & cv::Rect(0, 0, picture.cols, picture.rows);
  cv::Mat square(cut, cut, CV_8UC3, cv::Scalar::all(255));
  in_colour(picture(there)).copyTo(square(cv::Rect(there.tl() - wanted.tl(), there.size())));
  const double zoom = static_cast<double>(side) / cut;
  cv::Mat result;
  cv::resize(square, result, cv::Size(side, side), 0, 0, zoom > 1 ? cv::INTER_NEAREST : cv::INTER_AREA);

  const auto place = [&](Point p) { return Point{p.x - wanted.x, p.y - wanted.y}; };
  std::array<Point, 4> outline{};
  std::ranges::transform(grid.outline, outline.begin(), place);
  draw_polygon(result, outline, line_colours[1], 2, zoom);
  const double cell = std::sqrt(std::max(area_of(outline), 1.0)) * zoom / grid.width;
  const double radius = std::clamp(cell / 6, 1.5, 8.0);
  for (const SampleGrid::Sample& sample : grid.samples) {
    draw_dot(result, place(sample.at), radius + 1.5, cv::Scalar::all(sample.light ? 0 : 255), zoom);
    draw_dot(result, place(sample.at), radius, sample.light ? line_colours[4] : line_colours[0], zoom);
  }
  return result;
}

/// The largest markers side by side, at most nine.
StagePicture draw_grids(const StageTrace& trace) {
  constexpr std::size_t most = 9;
  constexpr int side = 360;
  const std::size_t count = std::min(trace.grids.size(), most);
  const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))));
  const int rows = std::max(1, (static_cast<int>(count) + columns - 1) / columns);
  cv::Mat picture(rows * side, columns * side, CV_8UC3, cv::Scalar::all(255));
  for (std::size_t i = 0; i < count; ++i) {
    const int column = static_cast<int>(i) % columns;
    const int row = static_cast<int>(i) / columns;
    draw_grid(trace.picture, trace.grids[i], side - 4)
        .copyTo(picture(cv::Rect(column * side + 2, row * side + 2, side - 4, side - 4)));
  }
  std::string what = "no quadrilateral to sample";
  if (count > 0) {
    what =
        trace.markers.empty() ? "samples of the largest quadrilateral" : "samples (orange light, blue dark)";
  }
  return {"6-grid", "pattern: " + what, picture};
}

}  // namespace

std::vector<StagePicture> draw_stages(const StageTrace& trace) {
  std::vector<StagePicture> pictures;
  pictures.push_back(
      {"1-original",
       "original, " + std::to_string(trace.picture.cols) + " x " + std::to_string(trace.picture.rows),
       in_colour(trace.picture)});
  for (const ScaleTrace& scale : trace.scales) {
    pictures.push_back({"2-threshold" + scale_suffix(scale.scale), "threshold" + scale_words(scale.scale),
                        in_colour(scale.thresholded), scale.scale == 1});
  }
  for (const ScaleTrace& scale : trace.scales) pictures.push_back(draw_preprocess(scale));
  pictures.push_back(draw_contours(trace));
  pictures.push_back(draw_corners(trace));
  pictures.push_back(draw_grids(trace));
  const std::size_t count = trace.markers.size();
  pictures.push_back({"7-markers", std::to_string(count) + (count == 1 ? " marker" : " markers"),
                      annotate(trace.picture, trace.markers)});
  return pictures;
}

}  // namespace runmark::cli
