#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// Parses the command line and runs what it asks for. The one place where errors become a line on stderr and
/// an exit status.
[[nodiscard]] int run_program(CLI::App& app, int argc, char** argv);

}  // namespace runmark::cli
