#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// `runmark detect INPUT...`: finds markers and prints them.
void add_detect_command(CLI::App& app);

}  // namespace runmark::cli
