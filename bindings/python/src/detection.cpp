#include "detection.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace py = pybind11;

namespace runmark::python {
namespace {

template <class T, class Value>
py::array_t<T> column(const FoundMarkers& found, const Value& value) {
  py::array_t<T> result(static_cast<py::ssize_t>(found.markers.size()));
  T* out = result.mutable_data();
  for (const Marker& marker : found.markers) *out++ = static_cast<T>(value(marker));
  return result;
}

double* put(const std::array<Point, 4>& corners, double* out) {
  for (const Point& corner : corners) {
    *out++ = corner.x;
    *out++ = corner.y;
  }
  return out;
}

py::array_t<double> corners_array(std::size_t count) {
  return py::array_t<double>({static_cast<py::ssize_t>(count), py::ssize_t{4}, py::ssize_t{2}});
}

py::array_t<double> corners_of(const FoundMarker& found) {
  py::array_t<double> result({4, 2});
  put(found.marker.corners, result.mutable_data());
  return result;
}

py::array_t<double> centre_of(const FoundMarker& found) {
  // Where the diagonals meet is what the middle of the square became under perspective.
  const auto& c = found.marker.corners;
  const double ax = c[2].x - c[0].x;
  const double ay = c[2].y - c[0].y;
  const double bx = c[3].x - c[1].x;
  const double by = c[3].y - c[1].y;
  const double t = ((c[1].x - c[0].x) * by - (c[1].y - c[0].y) * bx) / (ax * by - ay * bx);
  py::array_t<double> result(2);
  result.mutable_at(0) = c[0].x + t * ax;
  result.mutable_at(1) = c[0].y + t * ay;
  return result;
}

py::array_t<double> array_of(const std::array<double, 2>& values) {
  return py::array_t<double>(2, values.data());
}

std::string repr(const FoundMarker& found) {
  const Marker& m = found.marker;
  std::array<char, 160> corners{};
  std::snprintf(corners.data(), corners.size(), "[[%.2f, %.2f], [%.2f, %.2f], [%.2f, %.2f], [%.2f, %.2f]]",
                m.corners[0].x, m.corners[0].y, m.corners[1].x, m.corners[1].y, m.corners[2].x,
                m.corners[2].y, m.corners[3].x, m.corners[3].y);
  return "<Marker " + std::string(m.dictionary) + " " + std::to_string(m.id) + " at " + corners.data() + ">";
}

FoundMarker item(const FoundMarkers& found, py::ssize_t index) {
  const auto count = static_cast<py::ssize_t>(found.markers.size());
  if (index < 0) index += count;
  if (index < 0 || index >= count) throw py::index_error("there are " + std::to_string(count) + " markers");
  return {found.markers[static_cast<std::size_t>(index)], found.dictionaries};
}

void bind_marker(py::module_& module) {
  py::class_<FoundMarker>(module, "Marker", "One marker found in a frame.")
      .def_property_readonly(
          "dictionary", [](const FoundMarker& f) { return std::string(f.marker.dictionary); },
          "The name it was asked for by.")
      .def_property_readonly(
          "id", [](const FoundMarker& f) { return f.marker.id; }, "Index of the code in the dictionary.")
      .def_property_readonly(
          "corners", corners_of,
          "float64 (4, 2): x, y in pixels of the top-left, top-right, bottom-right and bottom-left corner "
          "of the marker as it is drawn; the centre of the top-left pixel is (0, 0).")
      .def_property_readonly("centre", centre_of,
                             "float64 (2,): x, y in pixels of the marker's middle, where its diagonals meet.")
      .def_property_readonly(
          "hamming", [](const FoundMarker& f) { return f.marker.hamming; }, "Wrong bits that were corrected.")
      .def_property_readonly(
          "margin", [](const FoundMarker& f) { return f.marker.margin; },
          "How far the cells are from being read the other way, as a share of the contrast: 0 (doubtful) "
          "to 0.5 (clear).")
      .def_property_readonly(
          "inverted", [](const FoundMarker& f) { return f.marker.inverted; }, "White on black.")
      .def_property_readonly(
          "row", [](const FoundMarker& f) { return f.marker.row; },
          "The frame row that had come in when the marker was given out.")
      .def_property_readonly(
          "rows", [](const FoundMarker& f) { return array_of(rows_of(f.marker)); },
          "float64 (2,): first and last row its square reaches, in pixels. Times the time from row to row, "
          "that is when a rolling shutter saw it.")
      .def("__repr__", repr);
}

void bind_stats(py::module_& module) {
  py::class_<FrameStats>(
      module, "FrameStats",
      "Counts of one frame: the work that was done, and what a full capacity made the detector drop.")
      .def_readonly("pixels", &FrameStats::pixels, "Pixels thresholded, all octaves.")
      .def_readonly("crack_runs", &FrameStats::crack_runs, "Inputs of the contour core.")
      .def_readonly("closed_chains", &FrameStats::closed_chains, "Contours that closed.")
      .def_readonly("quads", &FrameStats::quads, "Candidates the corner core handed on.")
      .def_readonly("records_peak", &FrameStats::records_peak, "Most records alive at once.")
      .def_readonly("dropped_chains", &FrameStats::dropped_chains, "Given up because no record was free.")
      .def_readonly("dropped_markers", &FrameStats::dropped_markers,
                    "Found after the list of markers was full.");
}

}  // namespace

void FoundMarkers::add(std::span<const Marker> found) {
  for (Marker marker : found) {
    marker.dictionary = std::ranges::find(*dictionaries, marker.dictionary, &Dictionary::name)->name;
    markers.push_back(marker);
  }
}

void FoundMarkers::finish(const Detector& detector) {
  add(detector.markers().subspan(markers.size()));
  rejected.assign(detector.rejected().begin(), detector.rejected().end());
  stats = detector.stats();
}

void bind_detection(py::module_& module) {
  bind_marker(module);
  bind_stats(module);
  py::class_<FoundMarkers>(
      module, "Detection",
      "The markers of one frame: a sequence of Marker, and the same as arrays with a row a marker.")
      .def("__len__", [](const FoundMarkers& f) { return f.markers.size(); })
      .def("__getitem__", item, py::arg("index"))
      .def("__iter__",
           [](const FoundMarkers& f) {
             py::list items;
             for (const Marker& marker : f.markers) items.append(FoundMarker{marker, f.dictionaries});
             return py::iter(items);
           })
      .def_property_readonly(
          "ids",
          [](const FoundMarkers& f) { return column<std::int32_t>(f, [](const Marker& m) { return m.id; }); },
          "int32 (N,): index of each code in its dictionary.")
      .def_property_readonly(
          "corners",
          [](const FoundMarkers& f) {
            py::array_t<double> result = corners_array(f.markers.size());
            double* out = result.mutable_data();
            for (const Marker& marker : f.markers) out = put(marker.corners, out);
            return result;
          },
          "float64 (N, 4, 2): x, y in pixels; top-left, top-right, bottom-right, bottom-left of the marker "
          "as it is drawn; the centre of the top-left pixel is (0, 0).")
      .def_property_readonly(
          "dictionaries",
          [](const FoundMarkers& f) {
            std::vector<std::string> names;
            for (const Marker& marker : f.markers) names.emplace_back(marker.dictionary);
            return names;
          },
          "N names of dictionaries.")
      .def_property_readonly(
          "hamming",
          [](const FoundMarkers& f) {
            return column<std::int32_t>(f, [](const Marker& m) { return m.hamming; });
          },
          "int32 (N,): wrong bits that were corrected.")
      .def_property_readonly(
          "margins",
          [](const FoundMarkers& f) { return column<float>(f, [](const Marker& m) { return m.margin; }); },
          "float32 (N,): 0 (doubtful) to 0.5 (clear), see Marker.margin.")
      .def_property_readonly(
          "inverted",
          [](const FoundMarkers& f) { return column<bool>(f, [](const Marker& m) { return m.inverted; }); },
          "bool (N,): white on black.")
      .def_property_readonly(
          "rows",
          [](const FoundMarkers& f) {
            py::array_t<double> result({static_cast<py::ssize_t>(f.markers.size()), py::ssize_t{2}});
            double* out = result.mutable_data();
            for (const Marker& marker : f.markers) out = std::ranges::copy(rows_of(marker), out).out;
            return result;
          },
          "float64 (N, 2): first and last row of each, in pixels; see Marker.rows.")
      .def_property_readonly(
          "size", [](const FoundMarkers& f) { return std::make_pair(f.width, f.height); },
          "Width and height of the frame, in pixels.")
      .def_property_readonly(
          "rejected",
          [](const FoundMarkers& f) {
            py::array_t<double> result = corners_array(f.rejected.size());
            double* out = result.mutable_data();
            for (const auto& corners : f.rejected) out = put(corners, out);
            return result;
          },
          "float64 (M, 4, 2): x, y in pixels of the squares in which no marker was read, clockwise; empty "
          "unless the detector has keep_rejected.")
      .def_readonly("stats", &FoundMarkers::stats, "What the frame's work came to.")
      .def("__repr__", [](const FoundMarkers& f) {
        return "<Detection of " + std::to_string(f.markers.size()) + " markers in " +
               std::to_string(f.width) + " x " + std::to_string(f.height) + " pixels>";
      });
}

}  // namespace runmark::python
