#include <CLI/CLI.hpp>
#include <exception>
#include <new>

#include "detect_command.h"
#include "dictionaries_command.h"
#include "errors.h"
#include "evaluate_command.h"
#include "library_messages.h"
#include "render_command.h"
#include "runmark/version.h"
#include "stages_command.h"

namespace runmark::cli {
namespace {

void add_commands(CLI::App& app) {
  add_detect_command(app);
  add_dictionaries_command(app);
  add_evaluate_command(app);
  add_render_command(app);
  add_stages_command(app);
}

int run(int argc, char** argv) {
  CLI::App app("Finds square fiducial markers in images, videos and camera streams", "runmark");
  app.set_version_flag("--version", "runmark " RUNMARK_VERSION);
  app.require_subcommand(0, 1);
  app.get_formatter()->column_width(34);
  add_commands(app);
  silence_libraries();
  try {
    app.parse(argc, argv);
    // Asked only now, so that `runmark --version` needs no command.
    if (app.get_subcommands().empty()) throw UserError("no command given; see runmark --help");
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    throw UserError(std::string(error.what()) + "; see runmark --help");
  }
  return 0;
}

}  // namespace
}  // namespace runmark::cli

// The one place where errors become a line on stderr and an exit status.
int main(int argc, char** argv) {
  using namespace runmark::cli;
  try {
    return run(argc, argv);
  } catch (const ExitStatus& status) {
    return status.value;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  return exit_failure;
}
