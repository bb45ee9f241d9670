#include "dictionary.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdio>
#include <string>

#include "render/draw_marker.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

Dictionary value_of(Result<Dictionary> result) {
  if (!result) throw py::value_error(result.error());
  return *std::move(result);
}

Dictionary from_object(const py::handle& given) {
  if (py::isinstance<Dictionary>(given)) return given.cast<Dictionary>();
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__")) {
    return value_of(load_dictionary(py::str(given)));
  }
  throw py::type_error("dictionaries: a name, a path or a Dictionary is wanted, not " +
                       std::string(py::str(py::type::of(given).attr("__name__"))));
}

/// The .codes text of a square dictionary.
Dictionary from_bits(const py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>& bits,
                     std::string name, int corrected_bits, const std::vector<int>& symmetric) {
  constexpr int most_bits = 64;
  const bool square = bits.ndim() == 3 && bits.shape(1) == bits.shape(2) && bits.shape(1) >= 1;
  if (!square || bits.shape(1) * bits.shape(2) > most_bits) {
    throw py::value_error("bits: shape " + std::string(py::str(bits.attr("shape"))) +
                          ", but it must be (N, S, S) with S from 1 to 8");
  }
  const auto side = static_cast<int>(bits.shape(1));
  const int count = side * side;
  std::string text = std::to_string(side) + " " + std::to_string(corrected_bits) + "\n";
  for (const int id : symmetric) text += "symmetric " + std::to_string(id) + "\n";
  const std::uint8_t* bit = bits.data();
  for (py::ssize_t i = 0; i < bits.shape(0); ++i) {
    unsigned long long code = 0;
    for (int b = 0; b < count; ++b) code = code << 1U | (*bit++ != 0 ? 1U : 0U);
    std::array<char, 20> digits{};
    std::snprintf(digits.data(), digits.size(), "%0*llx\n", (count + 3) / 4, code);
    text += digits.data();
  }
  return value_of(parse_codes(text, std::move(name)));
}

py::array_t<std::uint8_t> draw(const Dictionary& dictionary, py::ssize_t id, int pixels_per_cell,
                               int margin_cells) {
  if (id < 0 || id >= static_cast<py::ssize_t>(dictionary.codes.size())) {
    throw py::index_error("id " + std::to_string(id) + ": " + dictionary.name + " has 0 to " +
                          std::to_string(dictionary.codes.size() - 1));
  }
  constexpr int most = 1000;
  if (pixels_per_cell < 1 || pixels_per_cell > most || margin_cells < 0 || margin_cells > most) {
    throw py::value_error("pixels_per_cell must be 1 to 1000 and margin_cells 0 to 1000");
  }
  const MarkerDrawing drawing =
      draw_marker(dictionary, static_cast<std::size_t>(id), pixels_per_cell, margin_cells);
  py::array_t<std::uint8_t> result({drawing.side, drawing.side});
  std::copy(drawing.grey.begin(), drawing.grey.end(), result.mutable_data());
  return result;
}

py::array_t<std::int8_t> cells_of(const Dictionary& dictionary) {
  py::array_t<std::int8_t> result({static_cast<py::ssize_t>(dictionary.cells.size()), py::ssize_t{2}});
  std::int8_t* out = result.mutable_data();
  for (const Cell cell : dictionary.cells) {
    *out++ = cell.x;
    *out++ = cell.y;
  }
  return result;
}

}  // namespace

Dictionaries dictionaries_from(const py::object& given) {
  auto result = std::make_shared<std::vector<Dictionary>>();
  const bool one =
      py::isinstance<Dictionary>(given) || py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__");
  if (one) {
    result->push_back(from_object(given));
  } else if (py::isinstance<py::iterable>(given)) {
    for (const py::handle each : given) result->push_back(from_object(each));
  } else {
    result->push_back(from_object(given));  // throws
  }
  if (result->empty()) throw py::value_error("no dictionary given");
  return result;
}

void bind_dictionary(py::module_& module) {
  py::class_<Dictionary>(module, "Dictionary",
                         "A set of markers as data: where the data cells are, and codes.")
      .def(py::init([](const py::object& name) { return from_object(name); }), py::arg("name"),
           "A built-in dictionary by its name (dictionary_names() lists them), or a .codes file by its path.")
      .def_static(
          "from_codes",
          [](const std::string& text, std::string name) {
            return value_of(parse_codes(text, std::move(name)));
          },
          py::arg("text"), py::arg("name"), "Reads the text of a .codes file; see docs/dictionaries.md.")
      .def_static(
          "from_bits", from_bits, py::arg("bits"), py::arg("name"), py::arg("corrected_bits") = 0,
          py::arg("symmetric") = std::vector<int>{},
          "bits: (N, S, S), the data cells of N markers row by row, 1 is white; a black border of one cell "
          "goes round them. symmetric: ids that may look the same turned, so that their first corner is "
          "any of theirs.")
      .def_readonly("name", &Dictionary::name, "As asked for; of a file, its stem.")
      .def_readonly("width", &Dictionary::width,
                    "Cells along the side of the detected square, border included.")
      .def_property_readonly(
          "border",
          [](const Dictionary& d) {
            return d.border == Border::black      ? "black"
                   : d.border == Border::reversed ? "reversed"
                                                  : "included";
          },
          "'black' (ArUco, AprilTag 2), 'reversed' (AprilTag 3) or 'included' (templates of whole markers).")
      .def_readonly("corrected_bits", &Dictionary::corrected_bits,
                    "Wrong bits that are corrected unless the detector is told otherwise.")
      .def_readonly("distance", &Dictionary::distance,
                    "The least Hamming distance of two codes in any rotation.")
      .def_property_readonly(
          "cells", cells_of,
          "int8 (B, 2): x, y of each data cell; (0, 0) is the first cell of the detected square.")
      .def_property_readonly(
          "codes",
          [](const Dictionary& d) {
            return py::array_t<std::uint64_t>(static_cast<py::ssize_t>(d.codes.size()), d.codes.data());
          },
          "uint64 (N,): B bits each; cells[0] is the most significant one, 1 is white.")
      .def("draw", draw, py::arg("id"), py::arg("pixels_per_cell") = 8, py::arg("margin_cells") = 1,
           "uint8 (S, S): the marker upright, 0 black and 255 white, with white cells round it.")
      .def("__len__", [](const Dictionary& d) { return d.codes.size(); })
      .def("__repr__", [](const Dictionary& d) {
        return "<Dictionary " + d.name + ": " + std::to_string(d.codes.size()) + " markers>";
      });
  module.def(
      "dictionary_names",
      [] {
        const auto names = dictionary_names();
        return std::vector<std::string>(names.begin(), names.end());
      },
      "Names of the built-in dictionaries, sorted.");
}

}  // namespace runmark::python
