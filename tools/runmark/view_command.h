#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// `runmark view INPUT...`: hands over to the program runmark-view beside this one. Windows need libraries
/// that the other commands should neither wait for nor depend on.
void add_view_command(CLI::App& app);

}  // namespace runmark::cli
