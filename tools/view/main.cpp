#include <memory>

#include "input.h"
#include "program.h"
#include "view_loop.h"

int main(int argc, char** argv) {
  using namespace runmark::cli;
  CLI::App app("Show markers live in a window", "runmark view");
  ViewSettings settings;
  app.add_option("INPUT", settings.inputs, input_help)->required()->type_name("");
  add_detector_options(app, settings.detector);
  add_pose_options(app, settings.poses);
  app.add_option("--screenshots", settings.screenshots, "Folder for screenshots; the current one without it")
      ->type_name("DIR");
  app.footer(view_keys);
  app.callback([&settings] { view(settings); });
  return run_program(app, argc, argv);
}
