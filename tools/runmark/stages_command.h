#pragma once

#include <CLI/CLI.hpp>

namespace runmark::cli {

/// `runmark stages IMAGE -o DIR`: a picture of what each core makes of an image, and a sheet of all.
void add_stages_command(CLI::App& app);

}  // namespace runmark::cli
