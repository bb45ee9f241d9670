#include "calibrate_command.h"

#include <map>
#include <memory>

#include "calibrate_run.h"
#include "interrupt.h"
#include "pose_settings.h"

namespace runmark::cli {

void add_calibrate_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("calibrate", "Find a camera's lens from views of a board");
  const auto settings = std::make_shared<CalibrateSettings>();
  command->add_option("INPUT", settings->inputs, input_help)->required()->type_name("");
  command->add_option("--board", settings->board, board_help)->required()->type_name("BOARD");
  const std::map<std::string, Lens> lenses{
      {"plain", Lens::plain}, {"rational", Lens::rational}, {"fisheye", Lens::fisheye}};
  command->add_option("--lens", settings->lens, "Model of the lens (plain); rational for wide angles")
      ->transform(CLI::CheckedTransformer(lenses).description(""))
      ->type_name("plain|rational|fisheye");
  command->add_option("-o,--output", settings->output, "Write the camera as OpenCV YAML")->type_name("FILE");
  command->add_option("--ros", settings->ros, "Write the camera as ROS camera_info YAML")->type_name("FILE");
  command->add_option("--report", settings->report, "Write a web page with plots of what is left unexplained")
      ->type_name("FILE");
  command->add_option("--coverage", settings->coverage, "Write a picture of where corners were seen")
      ->type_name("FILE");
  command->add_option("--max-views", settings->most_views, "Views to use: those that differ most")
      ->check(CLI::Range(3, 1000).description(""))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--inverted", settings->detector.options.inverted, "The board is white on black");
  command->footer(
      "Show the whole board from all sides, tilted by 20 to 45 degrees, and in every corner of the picture; "
      "15 views or\n"
      "more. A camera is read until Ctrl-C. Views and corners that disagree with the others are left out and "
      "named.");
  command->callback([settings] {
    catch_interrupts();
    CalibrateRun(*settings).run();
  });
}

}  // namespace runmark::cli
