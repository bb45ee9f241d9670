#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/peers/reader.h"
#include "evaluate/observations.h"
#include "evaluate/truth_folder.h"

namespace runmark::bench {

/// What one contender saw in all images.
struct Run {
  std::string name;
  Observations observations;
};

/// Shows every image to every contender in turn, in this thread, so that all meet the same machine.
/// @param rounds    how often; an image's time is the median
/// @param progress  called after each image with its number
[[nodiscard]] Result<std::vector<Run>> run_contenders(const std::vector<const Contender*>& contenders,
                                                      const std::vector<TruthImage>& truth,
                                                      const TruthFolder& folder, int rounds,
                                                      const std::function<void(std::size_t)>& progress);

/// Writes the observations in the form that read_observations reads. False when the file cannot be.
[[nodiscard]] bool write_observations(const std::filesystem::path& file, const Observations& observations);

}  // namespace runmark::bench
