#pragma once

#include <string>
#include <vector>

#include "bench/speed/frames.h"

namespace runmark::bench {

/// CPU time of one worker on the frames of a set, each frame's median over the rounds, in milliseconds.
struct Timing {
  std::string worker;
  std::vector<double> milliseconds;  ///< a frame each, sorted
  [[nodiscard]] double median() const;
  [[nodiscard]] double p95() const;
  [[nodiscard]] double worst() const;
};

/// Every worker takes its turn on a frame, `rounds` times, after one turn that does not count. One that takes
/// less than 20 ms is called once more before each turn, so that all find the frame in the caches.
[[nodiscard]] std::vector<Timing> measure(const FrameSet& set, int rounds);

/// runmark alone on the first `scenes` scenes of a standard set: many tell more of how times spread than the
/// few that its slow peers take part in.
[[nodiscard]] Result<Timing> measure_alone(const std::string& set, int scenes, int rounds);

/// The timing of that worker.
[[nodiscard]] const Timing& timing_of(const std::vector<Timing>& timings, const std::string& worker);

}  // namespace runmark::bench
