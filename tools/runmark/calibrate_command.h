#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// Adds `runmark calibrate`: a camera from views of a board.
void add_calibrate_command(CLI::App& app);

}  // namespace runmark::cli
