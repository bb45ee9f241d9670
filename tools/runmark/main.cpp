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

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

/// Frames come and go, megabytes each, by several threads. To give their memory back to the system each time
/// and to get it anew, page by page, takes as long as to look for markers in them.
void keep_memory_of_frames() {
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  if (mallopt(M_MMAP_THRESHOLD, 256 * megabyte) == 0)
    mallopt(M_MMAP_THRESHOLD, 32 * megabyte);  // before 2.35
  mallopt(M_TRIM_THRESHOLD, 512 * megabyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  using namespace runmark::cli;
  keep_memory_of_frames();
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
