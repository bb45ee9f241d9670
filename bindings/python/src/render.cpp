#include "render.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <string>

#include "dictionary.h"
#include "render/colour.h"
#include "render/samples.h"
#include "render/standard_sets.h"
#include "render/truth_json.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

using render::Range;
using render::Recipe;

constexpr const char* render_doc = R"(A picture of markers with its exact truth, as (image, truth).

set         'vga', 'hd', 'fullhd' or 'uhd' (docs/render.md), or a sample: 'room', 'board', 'tilted', ...
index       number of the scene in its set
dictionary  name, path or Dictionary; None: 'tag36h11', or the sample's own
seed        other scenes of the same kind; 0 is the standard set
colour      uint8 (H, W, 3) in BGR instead of (H, W)
changes     instead of the set's own values, each a number or (low, high): marker_size (pixels), tilt (degrees),
            margin (cells), blur (standard deviation, pixels), motion (pixels), noise (grey levels), level,
            gradient, jpeg (quality); inverted=True

truth['markers'] must be found; each has 'id' and 'corners', x, y in pixels of the top-left, top-right, bottom-right
and bottom-left corner as drawn. Those in truth['maybe'] are cut or covered.)";

/// One of the changes: where it goes in a recipe and what it may be.
struct Change {
  const char* name;
  double least;
  double most;
  void (*apply)(Recipe&, Range);
};

constexpr std::array changes{
    Change{"marker_size", 2, 16384,
           [](Recipe& r, Range v) {
             r.sizes = {{v.low, v.high, 8}};
           }},
    Change{"tilt", 0, 85, [](Recipe& r, Range v) { r.tilt = v; }},
    Change{"margin", 0, 20, [](Recipe& r, Range v) { r.margin = v; }},
    Change{"blur", 0, 20, [](Recipe& r, Range v) { r.blur = v; }},
    Change{"motion", 0, 100,
           [](Recipe& r, Range v) {
             r.motion = {1, v};
           }},
    Change{"noise", 0, 100, [](Recipe& r, Range v) { r.noise = v; }},
    Change{"level", 0.01, 4, [](Recipe& r, Range v) { r.level = v; }},
    Change{"gradient", 0, 0.95, [](Recipe& r, Range v) { r.gradient = v; }},
    Change{"jpeg", 0, 100,
           [](Recipe& r, Range v) {
             r.jpeg = {1, v};
           }},
};

Range range_of(const std::string& name, const py::handle& value, double least, double most) {
  Range range;
  if (py::isinstance<py::sequence>(value)) {
    const auto both = value.cast<std::pair<double, double>>();
    range = {both.first, both.second};
  } else {
    range.low = range.high = value.cast<double>();
  }
  if (!(range.low >= least && range.low <= range.high && range.high <= most)) {
    throw py::value_error(
        name + " " + std::string(py::str(value)) + ": must be a number or (low, high) from " +
        std::string(py::str(py::float_(least))) + " to " + std::string(py::str(py::float_(most))));
  }
  return range;
}

void change(Recipe& recipe, const py::kwargs& given) {
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (name == "inverted") {
      recipe.inverted = value.cast<bool>();
      continue;
    }
    const auto known = std::ranges::find(changes, name, [](const Change& c) { return std::string(c.name); });
    if (known == changes.end()) throw py::type_error("render has no argument '" + name + "'");
    known->apply(recipe, range_of(name, value, known->least, known->most));
  }
}

/// A standard set or a sample by its name.
render::Sample find_set(const std::string& name) {
  if (const render::StandardSet* set = render::find_standard_set(name)) {
    return {set->name, "tag36h11", set->recipe, 0};
  }
  std::string names;
  for (const render::StandardSet& set : render::standard_sets()) names += std::string(set.name) + ", ";
  for (const render::Sample& sample : render::samples()) {
    if (sample.name == name) return sample;
    names += std::string(sample.name) + ", ";
  }
  throw py::value_error("set '" + name + "': there are " + names.substr(0, names.size() - 2));
}

py::tuple render_scene(const std::string& set, int index, const py::object& dictionary, std::uint64_t seed,
                       bool colour, const py::kwargs& given) {
  if (index < 0) throw py::value_error("index must not be negative");
  render::Sample sample = find_set(set);
  change(sample.recipe, given);
  const Dictionaries dictionaries =
      dictionaries_from(dictionary.is_none() ? py::str(std::string(sample.dictionary)) : dictionary);
  std::vector<std::uint8_t> pixels;
  render::RenderedFrame frame;
  {
    const py::gil_scoped_release nogil;
    const render::Scene scene = render::make_scene(sample.recipe, dictionaries->front(),
                                                   render::set_seed(sample.name, sample.seed + seed), index);
    frame = render::render(scene);
    pixels = colour ? render::colourise(scene, frame) : frame.grey;
  }
  std::vector<py::ssize_t> shape{frame.height, frame.width};
  if (colour) shape.push_back(3);
  py::array_t<std::uint8_t> image(shape);
  std::copy(pixels.begin(), pixels.end(), image.mutable_data());
  const std::string truth = render::to_json(frame.truth, "").dump();
  return py::make_tuple(image, py::module_::import("json").attr("loads")(truth));
}

}  // namespace

void bind_render(py::module_& module) {
  module.def("render", render_scene, py::arg("set") = "vga", py::arg("index") = 0, py::kw_only(),
             py::arg("dictionary") = py::none(), py::arg("seed") = 0, py::arg("colour") = false, render_doc);
}

}  // namespace runmark::python
