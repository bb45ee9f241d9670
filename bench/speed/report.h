#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "bench/speed/core_times.h"
#include "bench/speed/frames.h"
#include "bench/speed/measure.h"
#include "bench/speed/noise_sweep.h"
#include "bench/speed/time_model.h"

namespace runmark::bench {

/// All that is found out about one set of frames.
struct Figures {
  std::vector<Timing> timings;
  Timing spread;                    ///< of runmark, over more scenes where there are more
  std::vector<CoreTime> cores;      ///< medians over the frames
  std::vector<FrameWork> work;      ///< of each frame
  std::optional<NoiseSweep> noise;  ///< at the set's size
};

/// Writes the figures to standard output as a table.
void print(const FrameSet& set, const Figures& figures, int rounds);

/// The set's entry of `--json`.
[[nodiscard]] nlohmann::ordered_json to_json(const FrameSet& set, const Figures& figures, int rounds);

}  // namespace runmark::bench
