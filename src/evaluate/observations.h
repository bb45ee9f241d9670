#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/corners.h"
#include "runmark/detector.h"
#include "runmark/result.h"

namespace runmark {

/// A marker as some detector reported it.
struct Observation {
  int id = -1;
  Corners corners{};
};

[[nodiscard]] std::vector<Observation> observations_of(const Detection& detection);

/// What a detector reported for one image, and how long it took.
struct ImageObservations {
  std::vector<Observation> markers{};
  std::optional<double> milliseconds{};
};

/// By image.
using Observations = std::map<std::string, ImageObservations>;

/// Reads detections, one JSON object a line: {"image": name, "markers": [{"id": n, "corners": [[x, y],
/// [x, y], [x, y], [x, y]]}]}, with "ms" if the time is known. `runmark detect` says "source" for "image".
/// Other members are ignored. Errors give the line.
[[nodiscard]] Result<Observations> read_observations(const std::filesystem::path& file);

}  // namespace runmark
