#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// Adds `runmark print`: markers and boards on paper.
void add_print_command(CLI::App& app);

}  // namespace runmark::cli
