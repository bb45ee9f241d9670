#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// `runmark evaluate TRUTH.json`: scores detections, its own or a file's, against the truth.
void add_evaluate_command(CLI::App& app);

}  // namespace runmark::cli
