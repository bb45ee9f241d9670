#include "bench/speed/time_model.h"

#include <cmath>
#include <opencv2/core.hpp>

namespace runmark::bench {

TimeModel fit_time(const std::vector<FrameWork>& frames) {
  if (frames.size() < 3) return {};
  const int rows = static_cast<int>(frames.size());
  cv::Mat work(rows, 3, CV_64F);
  for (int i = 0; i < rows; ++i) {
    const FrameWork& frame = frames[static_cast<std::size_t>(i)];
    const double nanoseconds = frame.milliseconds * 1e6;
    work.at<double>(i, 0) = frame.pixels / nanoseconds;
    work.at<double>(i, 1) = frame.crack_runs / nanoseconds;
    work.at<double>(i, 2) = frame.markers / nanoseconds;
  }
  const cv::Mat ones = cv::Mat::ones(rows, 1, CV_64F);
  cv::Mat solution;
  cv::solve(work, ones, solution, cv::DECOMP_SVD);
  const double error = cv::norm(work * solution, ones, cv::NORM_L2) / std::sqrt(rows);
  return {solution.at<double>(0), solution.at<double>(1), solution.at<double>(2), error};
}

}  // namespace runmark::bench
