#pragma once

#include <pybind11/pybind11.h>

#include "detection.h"

namespace runmark::python {

/// A name, a path, a Dictionary, or several of these. Throws TypeError or ValueError.
[[nodiscard]] Dictionaries dictionaries_from(const pybind11::object& given);

void bind_dictionary(pybind11::module_& module);

}  // namespace runmark::python
