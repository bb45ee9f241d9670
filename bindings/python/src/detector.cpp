#include "detector.h"

#include <pybind11/stl.h>

#include "detection.h"
#include "detector_pool.h"
#include "dictionary.h"
#include "image.h"
#include "options.h"
#include "row_stream.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

constexpr const char* detector_doc = R"(Finds square markers in images of any size.

One detector can serve several threads at once; detect releases the GIL. Markers and arrays it gave stay valid
without it.

dictionaries     names (see dictionary_names()), paths of .codes files or Dictionary objects; one or several
pipeline         'default', 'paper' (the published system) or 'hardware' (what the FPGA core computes)
inverted         look for white-on-black markers too
min_marker_size, max_marker_size
                 side of the black square, pixels
corrected_bits   wrong bits corrected in a code; None: each dictionary's own safe number
min_margin       markers whose margin is less are not reported, 0 to 0.5
min_contrast     least difference between black and white, grey levels
octaves          how often the rows are halved to find large and blurred markers
region           (x, y, width, height) in pixels: look only there
filter           cases of the paper's Fig. 2 to mend, 'abcdef' or fewer; None: the pipeline's own
connectivity     whether dark pixels that meet at a corner touch (8) or not (4); None: the pipeline's own
fixed_threshold, above_is_dark, corner_offset
                 of the paper pipeline: grey level; which side of it is dark; pixels
keep_rejected    also give the squares that turned out to be no marker: Detection.rejected

Raises ValueError for an unknown dictionary or an option out of its range.)";

constexpr const char* detect_doc = R"(Finds the markers of an image.

image  uint8 (H, W) grey or (H, W, 3) colour, also (H, W, 1) and (H, W, 4); any strides: slices, flips and
       transposes are read where they lie, without a copy
order  'bgr' (as OpenCV has it) or 'rgb': which colour comes first

Raises TypeError when it is not uint8, ValueError for other shapes.)";

constexpr const char* stream_doc = R"(A frame that comes row by row, for a with statement:

    with detector.stream(1920, 1080) as stream:
        for rows in camera:
            for marker in stream.push(rows): ...

width, height  of the whole frame, pixels
copy           False: the arrays given to push are kept until the end of the block and must not be changed
               meanwhile
order          'bgr' or 'rgb')";

std::shared_ptr<DetectorPool> make(const py::object& dictionaries, const std::string& pipeline, bool inverted,
                                   double min_marker_size, double max_marker_size,
                                   std::optional<int> corrected_bits, float min_margin, int min_contrast,
                                   int octaves, const std::optional<RegionTuple>& region,
                                   const std::optional<std::string>& filter, std::optional<int> connectivity,
                                   int fixed_threshold, bool above_is_dark, int corner_offset,
                                   bool keep_rejected) {
  Options o;
  o.pipeline = pipeline_of(pipeline);
  o.inverted = inverted;
  o.min_marker_size = min_marker_size;
  o.max_marker_size = max_marker_size;
  o.corrected_bits = corrected_bits.value_or(-1);
  o.min_margin = min_margin;
  o.min_contrast = min_contrast;
  o.octaves = octaves;
  if (region)
    o.region = {std::get<0>(*region), std::get<1>(*region), std::get<2>(*region), std::get<3>(*region)};
  o.filter = filter_of(filter);
  o.connectivity = connectivity_of(connectivity);
  o.fixed_threshold = fixed_threshold;
  o.above_is_dark = above_is_dark;
  o.corner_offset = corner_offset;
  o.keep_rejected = keep_rejected;
  auto pool = std::make_shared<DetectorPool>(o, dictionaries_from(dictionaries));
  // What is wrong with the options is told here, not with the first frame.
  if (const auto tried = pool->borrow(1, 1, false); !tried) throw py::value_error(tried.error());
  return pool;
}

FoundMarkers detect(DetectorPool& pool, const py::object& image, const std::string& order) {
  const ArrayView array = view_of(image, order, "image");
  FoundMarkers found;
  found.width = array.view.width;
  found.height = array.view.height;
  found.dictionaries = pool.dictionaries();
  std::string error;
  {
    const py::gil_scoped_release nogil;
    Result<DetectorPool::Lease> detector = pool.borrow(found.width, found.height, false);
    if (detector) {
      const Detection detection = (*detector)->detect(array.view);
      if (detection.status != Status::ok) error = describe(detection.status);
      found.finish(**detector);
    } else {
      error = detector.error();
    }
  }
  if (!error.empty()) throw py::value_error("image: " + error);
  return found;
}

std::vector<std::string> names_of(const DetectorPool& pool) {
  std::vector<std::string> names;
  for (const Dictionary& dictionary : *pool.dictionaries()) names.push_back(dictionary.name);
  return names;
}

}  // namespace

void bind_detector(py::module_& module) {
  const Options o;
  py::class_<DetectorPool, std::shared_ptr<DetectorPool>>(module, "Detector", detector_doc)
      .def(py::init(&make), py::arg("dictionaries"), py::kw_only(), py::arg("pipeline") = "default",
           py::arg("inverted") = o.inverted, py::arg("min_marker_size") = o.min_marker_size,
           py::arg("max_marker_size") = o.max_marker_size, py::arg("corrected_bits") = py::none(),
           py::arg("min_margin") = o.min_margin, py::arg("min_contrast") = o.min_contrast,
           py::arg("octaves") = o.octaves, py::arg("region") = py::none(), py::arg("filter") = py::none(),
           py::arg("connectivity") = py::none(), py::arg("fixed_threshold") = o.fixed_threshold,
           py::arg("above_is_dark") = o.above_is_dark, py::arg("corner_offset") = o.corner_offset,
           py::arg("keep_rejected") = o.keep_rejected)
      .def("detect", &detect, py::arg("image"), py::kw_only(), py::arg("order") = "bgr", detect_doc)
      .def(
          "stream",
          [](const std::shared_ptr<DetectorPool>& pool, int width, int height, bool copy, std::string order) {
            return std::make_unique<RowStream>(pool, width, height, copy, std::move(order));
          },
          py::arg("width"), py::arg("height"), py::kw_only(), py::arg("copy") = true,
          py::arg("order") = "bgr", stream_doc)
      .def_property_readonly("dictionaries", &names_of, "Names of the dictionaries it looks for.")
      .def_property_readonly(
          "memory", &DetectorPool::memory,
          "Bytes it holds between calls: one set of buffers for each size of frame, by powers of two, and "
          "for each thread that was in detect at once.")
      .def("__repr__", [](const DetectorPool& pool) {
        std::string text = "<Detector of";
        for (const std::string& name : names_of(pool)) text += " " + name;
        return text + ">";
      });
}

}  // namespace runmark::python
