#include "pose/refine_pose.h"

#include <algorithm>
#include <cmath>

#include "camera/lens.h"
#include "pose/damped_step.h"

namespace runmark {
namespace {

using Step = cv::Vec6d;  // of the translation, then of the rotation about the camera's axes

/// The normal equations at a pose.
struct Linearised {
  cv::Matx66d information = cv::Matx66d::zeros();
  Step gradient = Step::zeros();
  double chi2 = 0;
  double square_error = 0;  // of all points, in square pixels
};

/// A point's offset (seen minus projected) in pixels and its derivatives by the step.
struct Offset {
  cv::Vec2d offset;
  cv::Matx<double, 2, 6> by;
};

std::optional<Offset> offset_of(const Camera& camera, const Pose& pose, const Point3& object, Point seen) {
  const Point3 p = pose(object);
  if (!(p.z > 0)) return {};
  const Point direction{p.x / p.z, p.y / p.z};
  const Bent bent = bend(camera, direction);
  Offset o;
  o.offset = {seen.x - camera.cx - camera.fx * bent.at.x, seen.y - camera.cy - camera.fy * bent.at.y};
  // Of the direction by the point in space, then of the point by the step.
  const cv::Matx23d by_point = cv::Matx22d(camera.fx * bent.by[0], camera.fx * bent.by[1],  //
                                           camera.fy * bent.by[2], camera.fy * bent.by[3]) *
                               cv::Matx23d(1 / p.z, 0, -direction.x / p.z,  //
                                           0, 1 / p.z, -direction.y / p.z);
  const Point3 arm{p.x - pose.translation.x, p.y - pose.translation.y, p.z - pose.translation.z};
  const cv::Matx33d by_turn(0, arm.z, -arm.y, -arm.z, 0, arm.x, arm.y, -arm.x, 0);
  const cv::Matx23d turned = by_point * by_turn;
  for (int row = 0; row < 2; ++row) {
    for (int k = 0; k < 3; ++k) {
      o.by(row, k) = by_point(row, k);
      o.by(row, k + 3) = turned(row, k);
    }
  }
  return o;
}

std::optional<Linearised> linearise(const Observation& seen, const Camera& camera, const Pose& pose) {
  Linearised sums;
  std::size_t point = 0;
  for (const Observation::Group& group : seen.groups) {
    cv::Matx<double, 8, 6> by;
    cv::Vec<double, 8> offsets;
    for (int i = 0; i < group.points; ++i, ++point) {
      const std::optional<Offset> o = offset_of(camera, pose, seen.object[point], seen.image[point]);
      if (!o) return {};
      for (int row = 0; row < 2; ++row) {
        offsets[2 * i + row] = o->offset[row];
        for (int k = 0; k < 6; ++k) by(2 * i + row, k) = o->by(row, k);
      }
      sums.square_error += o->offset.dot(o->offset);
    }
    const int rows = 2 * group.points;
    for (int row = 0; row < rows; ++row) {
      double white = 0;
      Step white_by = Step::zeros();
      for (int j = 0; j <= row; ++j) {
        const double w = group.whitener(row, j);
        white += w * offsets[j];
        for (int k = 0; k < 6; ++k) white_by[k] += w * by(j, k);
      }
      sums.chi2 += white * white;
      sums.gradient += white * white_by;
      for (int a = 0; a < 6; ++a) {
        for (int b = 0; b < 6; ++b) sums.information(a, b) += white_by[a] * white_by[b];
      }
    }
  }
  return sums;
}

Pose moved(const Pose& pose, const Step& step) {
  const Pose turn = pose_from({step[3], step[4], step[5]}, {});
  Pose result = turn * pose;
  result.translation = {pose.translation.x + step[0], pose.translation.y + step[1],
                        pose.translation.z + step[2]};
  return result;
}

std::optional<PoseCovariance> covariance_of(const cv::Matx66d& information) {
  PoseCovariance covariance{};
  for (int column = 0; column < 6; ++column) {
    Step unit = Step::zeros();
    unit[column] = 1;
    Step solved;
    if (!damped_step(information, unit, 0, solved)) return {};
    for (int row = 0; row < 6; ++row) {
      if (!std::isfinite(solved[row])) return {};
      covariance[static_cast<std::size_t>(6 * row + column)] = solved[row];
    }
  }
  return covariance;
}

}  // namespace

std::optional<RefinedPose> refine_pose(const Observation& seen, const Camera& camera, const Pose& start) {
  constexpr int most_steps = 60;
  Pose pose = start;
  std::optional<Linearised> here = linearise(seen, camera, pose);
  if (!here) return {};
  double damping = 1e-4;
  for (int i = 0; i < most_steps && damping < 1e8; ++i) {
    Step step;
    if (!damped_step(here->information, here->gradient, damping, step)) return {};
    const Pose next = moved(pose, step);
    const std::optional<Linearised> there = linearise(seen, camera, next);
    if (!there || !(there->chi2 < here->chi2)) {
      damping *= 10;
      continue;
    }
    const double gain = here->chi2 - there->chi2;
    pose = next;
    here = there;
    damping = std::max(damping / 10, 1e-12);
    if (gain < 1e-10 * (here->chi2 + 1e-6)) break;
  }
  std::optional<PoseCovariance> covariance = covariance_of(here->information);
  if (!covariance) return {};
  // Many corners tell when the camera or the object is not as described: then less is known than they
  // promise.
  constexpr double enough = 10;
  const double freedom = 2.0 * static_cast<double>(seen.image.size()) - 6;
  if (freedom >= enough) {
    const double factor = std::max(1.0, here->chi2 / freedom);
    for (double& c : *covariance) c *= factor;
  }
  const double error = std::sqrt(here->square_error / static_cast<double>(seen.image.size()));
  return RefinedPose{{pose, error, *covariance}, here->chi2};
}

}  // namespace runmark
