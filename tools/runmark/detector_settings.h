#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "runmark/board.h"
#include "runmark/dictionary.h"
#include "runmark/options.h"

namespace runmark::cli {

/// What the command line says about the detector.
struct DetectorSettings {
  Options options;
  std::vector<std::string> dictionary_names;  ///< empty: the default set
};

/// Adds --dict, --pipeline and the detector's tunables to a command.
void add_detector_options(CLI::App& command, DetectorSettings& settings);

/// Adds those of the board's markers to the dictionaries asked for.
void add_dictionaries_of(const Board& board, DetectorSettings& settings);

/// The dictionaries asked for, or the default set. Throws UserError.
[[nodiscard]] std::vector<Dictionary> load_dictionaries(const DetectorSettings& settings);

}  // namespace runmark::cli
