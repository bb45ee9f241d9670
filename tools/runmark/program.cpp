#include "program.h"

#include <exception>
#include <new>
#include <string>

#include "errors.h"
#include "library_messages.h"

namespace runmark::cli {

int run_program(CLI::App& app, int argc, char** argv) {
  app.get_formatter()->column_width(34);
  silence_libraries();
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    print_error(std::string(error.what()) + "; see " + app.get_name() + " --help");
  } catch (const ExitStatus& status) {
    return status.value;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  return exit_failure;
}

}  // namespace runmark::cli
