#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "input.h"

namespace runmark::cli {

/// What an earlier run has made of one input.
struct EarlierFrames {
  std::int64_t count = 0;  ///< its first frames, whose lines are there
  bool ended = false;      ///< and it had no more of them, or broke there
};

/// What a run that was stopped left in its output.
struct EarlierRun {
  std::uint64_t bytes = 0;            ///< of whole lines; a line that was cut off stands behind them
  std::vector<EarlierFrames> inputs;  ///< one for each input
};

/// Reads the JSON lines an earlier run over `inputs` wrote to `path`; without that file nothing was done.
/// Throws UserError for an input that cannot be gone on with, and for a file that another command wrote.
[[nodiscard]] EarlierRun read_earlier_run(const std::string& path, const std::vector<Input>& inputs);

}  // namespace runmark::cli
