#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "corner/quad.h"
#include "runmark/detector.h"

namespace runmark::cli {

/// A contour the contour core handed on: its corners in pixels of the frame.
struct TracedContour {
  std::vector<Point> corners;
  bool hole = false;
};

/// What the first four cores made of the frame at one scale.
struct ScaleTrace {
  int scale = 1;         ///< pixels of the frame along a pixel of this scale
  cv::Mat thresholded;   ///< 8-bit grey, 0 dark and 255 light
  cv::Mat preprocessed;  ///< the same after the white border and the filter
  std::uint64_t crack_runs = 0;
  std::uint64_t closed = 0;  ///< contours, those too low or too winding included
  std::vector<TracedContour> contours;
  std::vector<Quad> quads;  ///< in pixels of the frame
};

/// Where the pattern core looks at a marker's cells.
struct SampleGrid {
  struct Sample {
    Point at;
    bool light = false;
  };
  std::array<Point, 4> outline{};  ///< of the square of cells
  int width = 0;                   ///< cells along its side
  std::vector<Sample> samples;
};

/// What all five cores handed on from one frame.
struct StageTrace {
  cv::Mat picture;  ///< the part of the frame that was looked at
  cv::Mat grey;
  std::vector<ScaleTrace> scales;  ///< full size first
  std::vector<SampleGrid> grids;   ///< one a marker, the largest first; without markers of the largest quad
  std::vector<Marker> markers;     ///< names point into the dictionaries given to trace_stages
  FrameStats stats;
};

/// Runs the cores of Options::pipeline one after the other over a whole picture, grey or
/// BGR. Throws UserError when the detector refuses the options or the picture.
[[nodiscard]] StageTrace trace_stages(const cv::Mat& picture, const Options& options,
                                      const std::vector<Dictionary>& dictionaries);

}  // namespace runmark::cli
