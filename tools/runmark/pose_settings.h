#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace runmark::cli {

/// What the command line says about poses.
struct PoseSettings {
  std::string camera;              ///< a camera file; empty: no poses
  std::vector<std::string> sizes;  ///< of markers, as MarkerSizes reads them
  std::string board;               ///< as load_board reads it; empty: none
};

/// Adds --camera-info, --marker-size and --board to a command.
void add_pose_options(CLI::App& command, PoseSettings& settings);

/// What to say about boards in a command's help.
inline constexpr const char* board_help =
    "A board: charuco:DICT:COLUMNSxROWS:SQUARE:MARKER[:legacy][:turned], grid:DICT:COLUMNSxROWS:MARKER:GAP, "
    "or a "
    ".json file";

}  // namespace runmark::cli
