#pragma once

#include <pybind11/pybind11.h>

namespace runmark::python {

void bind_confirmation(pybind11::module_& module);

}  // namespace runmark::python
