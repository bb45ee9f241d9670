#pragma once

#include <pybind11/pybind11.h>

namespace runmark::python {

void bind_board(pybind11::module_& module);

}  // namespace runmark::python
