#include <pybind11/pybind11.h>

#include "board.h"
#include "camera.h"
#include "confirmation.h"
#include "detection.h"
#include "detector.h"
#include "dictionary.h"
#include "pose.h"
#include "render.h"
#include "row_stream.h"
#include "runmark/version.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "runmark's C++ core; import runmark instead.";
  module.attr("__version__") = RUNMARK_VERSION;
  runmark::python::bind_dictionary(module);
  runmark::python::bind_detection(module);
  runmark::python::bind_confirmation(module);
  runmark::python::bind_row_stream(module);
  runmark::python::bind_detector(module);
  runmark::python::bind_camera(module);
  runmark::python::bind_pose(module);
  runmark::python::bind_board(module);
  runmark::python::bind_render(module);
}
