#pragma once

#include <vector>

namespace runmark::bench {

/// The work in one frame and what it took.
struct FrameWork {
  double pixels = 0;  ///< thresholded, all octaves
  double crack_runs = 0;
  double markers = 0;
  double milliseconds = 0;
};

/// Time of a frame as so much for each pixel, crack run and marker, in nanoseconds.
struct TimeModel {
  double per_pixel = 0;
  double per_crack_run = 0;
  double per_marker = 0;
  double error = 0;  ///< root mean square of the relative error
};

/// Least squares of the relative errors, so that small frames count as much as large ones.
[[nodiscard]] TimeModel fit_time(const std::vector<FrameWork>& frames);

}  // namespace runmark::bench
