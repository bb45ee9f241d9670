#pragma once

#include <pybind11/pybind11.h>

#include "runmark/pose.h"

namespace runmark::python {

/// Throws ValueError with the error's message.
[[nodiscard]] PoseEstimate value_of(Result<PoseEstimate> estimate);

void bind_pose(pybind11::module_& module);

}  // namespace runmark::python
