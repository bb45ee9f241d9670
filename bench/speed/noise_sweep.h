#pragma once

#include <cstdint>
#include <vector>

namespace runmark::bench {

/// One kind of random frame: cells of granularity x granularity pixels, each black with the chance
/// `density`, else white; and what the detector makes of it.
struct NoiseCell {
  double density = 0;
  int granularity = 1;
  double milliseconds = 0;  ///< CPU time, median over the rounds
  std::uint64_t crack_runs = 0;
  std::uint64_t records_peak = 0;
  std::uint64_t dropped_chains = 0;
};

struct NoiseSweep {
  std::vector<NoiseCell> cells;
  std::size_t memory = 0;  ///< of the detector, bytes; the same for every frame
  [[nodiscard]] double worst() const;
};

/// Density 0 to 1 in steps of a tenth, granularity 1 to 16: the way of the YACCLAB benchmark (Grana et
/// al., ICPR 2016) of connected components labelling.
[[nodiscard]] NoiseSweep sweep_noise(int width, int height, int rounds);

}  // namespace runmark::bench
