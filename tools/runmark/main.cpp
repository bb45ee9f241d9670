#include "calibrate_command.h"
#include "detect_command.h"
#include "dictionaries_command.h"
#include "errors.h"
#include "evaluate_command.h"
#include "print_command.h"
#include "program.h"
#include "render_command.h"
#include "runmark/version.h"
#include "stages_command.h"
#include "view_command.h"

int main(int argc, char** argv) {
  using namespace runmark::cli;
  CLI::App app("Finds square fiducial markers in images, videos and camera streams", "runmark");
  app.set_version_flag("--version", "runmark " RUNMARK_VERSION);
  app.require_subcommand(0, 1);
  add_calibrate_command(app);
  add_detect_command(app);
  add_dictionaries_command(app);
  add_evaluate_command(app);
  add_print_command(app);
  add_render_command(app);
  add_stages_command(app);
  add_view_command(app);
  // Asked only when all is parsed, so that `runmark --version` needs no command.
  app.callback([&app] {
    if (app.get_subcommands().empty()) throw UserError("no command given; see runmark --help");
  });
  return run_program(app, argc, argv);
}
