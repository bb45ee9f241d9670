#include <pybind11/pybind11.h>

#include "detection.h"
#include "detector.h"
#include "dictionary.h"
#include "render.h"
#include "row_stream.h"
#include "runmark/version.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "runmark's C++ core; import runmark instead.";
  module.attr("__version__") = RUNMARK_VERSION;
  runmark::python::bind_dictionary(module);
  runmark::python::bind_detection(module);
  runmark::python::bind_row_stream(module);
  runmark::python::bind_detector(module);
  runmark::python::bind_render(module);
}
