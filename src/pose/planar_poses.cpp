#include "pose/planar_poses.h"

#include <opencv2/calib3d.hpp>

#include "pose/opencv_pose.h"

namespace runmark {

std::vector<Pose> planar_poses(const std::vector<Point3>& object, const std::vector<Point>& directions) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pictures;
  for (const Point3& p : object) points.emplace_back(p.x, p.y, p.z);
  for (const Point& p : directions) pictures.emplace_back(p.x, p.y);
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> places;
  cv::solvePnPGeneric(points, pictures, cv::Matx33d::eye(), cv::noArray(), turns, places, false,
                      cv::SOLVEPNP_IPPE);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    poses.push_back(pose_from_opencv(turns[i], places[i]));
  }
  return poses;
}

}  // namespace runmark
