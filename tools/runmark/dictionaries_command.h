#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "runmark/dictionary.h"

namespace runmark::cli {

/// One line for each dictionary: what it holds, what is corrected, what looking codes up takes. `format` is
/// "text", "json" (one array) or "markdown" (the table of docs/dictionaries.md).
[[nodiscard]] std::string dictionary_table(const std::vector<Dictionary>& dictionaries,
                                           const std::string& format);

/// `runmark dictionaries [NAME...]`: what dictionaries there are.
void add_dictionaries_command(CLI::App& app);

}  // namespace runmark::cli
