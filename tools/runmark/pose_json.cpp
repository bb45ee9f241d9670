#include "pose_json.h"

#include <cmath>

namespace runmark::cli {
namespace {

using Json = nlohmann::ordered_json;

/// To eight significant digits, so that no tail of nines is printed.
double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const double scale = std::pow(10.0, 7 - std::floor(std::log10(std::fabs(value))));
  return std::isfinite(scale) ? std::round(value * scale) / scale : 0;
}

double pixels(double value) { return std::round(value * 1000) / 1000 + 0.0; }

Json to_json(const Point3& p) { return Json::array({rounded(p.x), rounded(p.y), rounded(p.z)}); }

Json to_json(const PoseSolution& solution) {
  const auto [x, y, z, w] = quaternion(solution.pose);
  Json covariance = Json::array();
  for (const double c : solution.covariance) covariance.push_back(rounded(c));
  return {{"translation", to_json(solution.pose.translation)},
          {"quaternion", Json::array({rounded(x), rounded(y), rounded(z), rounded(w)})},
          {"rotation_vector", to_json(rotation_vector(solution.pose))},
          {"error", pixels(solution.error)},
          {"covariance", covariance}};
}

}  // namespace

Json to_json(const PoseEstimate& estimate) {
  Json json = to_json(estimate.best);
  json["ambiguity"] = rounded(estimate.ambiguity);
  if (estimate.other) json["other"] = to_json(*estimate.other);
  return json;
}

Json board_json(const FramePoses& poses) {
  Json corners = Json::array();
  for (const SeenCorner& corner : poses.board.corners) {
    corners.push_back({{"id", corner.index},
                       {"place", Json::array({pixels(corner.place.x), pixels(corner.place.y)})},
                       {"deviation", pixels(corner.deviation)}});
  }
  Json json{{"markers", poses.board.markers.size()}, {"corners", corners}};
  if (poses.board_pose) json["pose"] = to_json(*poses.board_pose);
  if (!poses.advice.empty()) json["advice"] = poses.advice;
  return json;
}

}  // namespace runmark::cli
