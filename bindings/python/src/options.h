#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "runmark/options.h"

namespace runmark::python {

/// Region of the frame as Python gives it: x, y, width, height.
using RegionTuple = std::tuple<int, int, int, int>;

/// Throw ValueError for names there are not.
[[nodiscard]] Pipeline pipeline_of(const std::string& name);
[[nodiscard]] Connectivity connectivity_of(std::optional<int> neighbours);
[[nodiscard]] std::uint8_t filter_of(const std::optional<std::string>& cases);

}  // namespace runmark::python
