#include "pose_settings.h"

namespace runmark::cli {

void add_pose_options(CLI::App& command, PoseSettings& settings) {
  command
      .add_option(
          "--camera-info", settings.camera,
          "The camera that took the pictures: a YAML file of OpenCV or ROS, as runmark calibrate writes it")
      ->type_name("FILE");
  command
      .add_option(
          "--marker-size", settings.sizes,
          "Side of the markers in your unit, for their poses: SIZE for all, ID=SIZE, FIRST-LAST=SIZE or "
          "DICT:ID=SIZE for some; may be given several times")
      ->allow_extra_args(false)
      ->type_name("SIZE");
  command
      .add_option("--board", settings.board,
                  std::string(board_help) + ". With --camera-info its pose is printed")
      ->type_name("BOARD");
}

}  // namespace runmark::cli
