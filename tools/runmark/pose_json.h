#pragma once

#include <nlohmann/json.hpp>

#include "pose_finder.h"

namespace runmark::cli {

/// As docs/pose.md describes it.
[[nodiscard]] nlohmann::ordered_json to_json(const PoseEstimate& estimate);
/// What is seen of the board, and its pose where there is one.
[[nodiscard]] nlohmann::ordered_json board_json(const FramePoses& poses);

}  // namespace runmark::cli
