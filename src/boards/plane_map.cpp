#include "boards/plane_map.h"

#include <opencv2/calib3d.hpp>

namespace runmark {

std::optional<PlaneMap> PlaneMap::fit(const std::vector<Point>& board, const std::vector<Point>& picture) {
  std::vector<cv::Point2d> from;
  std::vector<cv::Point2d> to;
  for (const Point& p : board) from.emplace_back(p.x, p.y);
  for (const Point& p : picture) to.emplace_back(p.x, p.y);
  if (from.size() < 4) return {};
  const cv::Mat map = cv::findHomography(from, to, 0);
  if (map.empty()) return {};
  return PlaneMap(cv::Matx33d(map.ptr<double>()));
}

Point PlaneMap::operator()(Point p) const {
  const cv::Vec3d q = map_ * cv::Vec3d(p.x, p.y, 1);
  return {q[0] / q[2], q[1] / q[2]};
}

}  // namespace runmark
