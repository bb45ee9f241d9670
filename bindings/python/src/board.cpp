#include "board.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "detection.h"
#include "dictionary.h"
#include "image.h"
#include "pose.h"
#include "runmark/board_file.h"
#include "runmark/board_view.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

constexpr const char* board_doc = R"(Markers whose places are known relative to each other.

description  charuco:DICTIONARY:COLUMNSxROWS:SQUARE:MARKER[:legacy][:turned],
             grid:DICTIONARY:COLUMNSxROWS:MARKER:GAP, or the path of a .json file (docs/boards.md)

The frame of a grid or ChArUco board has its origin in the board's top-left corner, x to the right, y down and z into
the sheet. Lengths are in any unit; poses come in it.)";

constexpr const char* view_doc = R"(What an image shows of the board.

detection  what Detector.detect gave for this image
image      as for Detector.detect
order      'bgr' or 'rgb')";

/// What an image shows of a board, and which one.
struct View {
  Board board;
  BoardView view;
};

Board value_of(Result<Board> board) {
  if (!board) throw py::value_error(board.error());
  return *std::move(board);
}

Dictionary one_dictionary(const py::object& given) {
  const Dictionaries all = dictionaries_from(given);
  if (all->size() != 1) throw py::value_error("dictionary: one is wanted");
  return all->front();
}

Board grid(const py::object& dictionary, int columns, int rows, double marker, double gap, int first_id) {
  return value_of(grid_board(one_dictionary(dictionary), {columns, rows, marker, gap, first_id}));
}

Board charuco(const py::object& dictionary, int columns, int rows, double square, double marker, int first_id,
              bool legacy, bool turned) {
  return value_of(
      charuco_board(one_dictionary(dictionary), {columns, rows, square, marker, first_id, legacy, turned}));
}

View view(const Board& board, const FoundMarkers& found, const py::object& image, const std::string& order) {
  const ArrayView array = view_of(image, order, "image");
  if (array.view.width != found.width || array.view.height != found.height) {
    throw py::value_error("image: of another size than the frame of this detection");
  }
  const py::gil_scoped_release nogil;
  return {board, view_board(board, found.markers, array.view)};
}

template <class Value>
py::array_t<std::int32_t> numbers_of(std::size_t count, const Value& value) {
  py::array_t<std::int32_t> result(static_cast<py::ssize_t>(count));
  for (std::size_t i = 0; i < count; ++i) result.mutable_data()[i] = value(i);
  return result;
}

py::array_t<double> marker_corners_of(const Board& board) {
  py::array_t<double> result(
      {static_cast<py::ssize_t>(board.markers.size()), py::ssize_t{4}, py::ssize_t{3}});
  double* out = result.mutable_data();
  for (const BoardMarker& marker : board.markers) {
    for (const Point3& corner : marker.corners) {
      put(corner, out);
      out += 3;
    }
  }
  return result;
}

}  // namespace

void bind_board(py::module_& module) {
  py::class_<View>(module, "BoardView", "What an image shows of a board.")
      .def_property_readonly(
          "ids",
          [](const View& v) {
            return numbers_of(v.view.markers.size(),
                              [&](std::size_t i) { return v.view.markers[i].marker.id; });
          },
          "int32 (N,): ids of the board's markers that are seen.")
      .def_property_readonly(
          "chess_ids",
          [](const View& v) {
            return numbers_of(v.view.corners.size(), [&](std::size_t i) { return v.view.corners[i].index; });
          },
          "int32 (K,): numbers of the chessboard corners that are seen, as OpenCV's charucoIds.")
      .def_property_readonly(
          "chess_corners",
          [](const View& v) {
            return rows_of<2>(v.view.corners, [](const SeenCorner& c, double* out) { put(c.place, out); });
          },
          "float64 (K, 2): where, x, y in pixels.")
      .def_property_readonly(
          "chess_deviations",
          [](const View& v) {
            py::array_t<double> result(static_cast<py::ssize_t>(v.view.corners.size()));
            double* out = result.mutable_data();
            for (const SeenCorner& corner : v.view.corners) *out++ = corner.deviation;
            return result;
          },
          "float64 (K,): how sure: the standard deviation of x and of y, in pixels.")
      .def(
          "pose",
          [](const View& v, const Camera& camera) {
            return value_of(runmark::pose(v.board, v.view, camera));
          },
          py::arg("camera"),
          "The board's pose from all corners seen. Raises ValueError when too little of it is seen.");
  py::class_<Board>(module, "Board", board_doc)
      .def(py::init([](const py::object& description) { return value_of(load_board(py::str(description))); }),
           py::arg("description"))
      .def_static("grid", &grid, py::arg("dictionary"), py::arg("columns"), py::arg("rows"),
                  py::arg("marker"), py::arg("gap"), py::arg("first_id") = 0,
                  "Rows of markers with that side and that gap between two.")
      .def_static(
          "charuco", &charuco, py::arg("dictionary"), py::arg("columns"), py::arg("rows"), py::arg("square"),
          py::arg("marker"), py::arg("first_id") = 0, py::arg("legacy") = false, py::arg("turned") = false,
          "A chessboard of columns x rows squares with markers in the white ones. legacy: as OpenCV before "
          "4.6 lays it out; turned: markers on their heads, as OpenCV 4 prints its AprilTag dictionaries.")
      .def_property_readonly(
          "ids",
          [](const Board& b) {
            return numbers_of(b.markers.size(), [&](std::size_t i) { return b.markers[i].id; });
          },
          "int32 (N,): of its markers.")
      .def_property_readonly("corners", &marker_corners_of,
                             "float64 (N, 4, 3): where their corners are, in the board's frame.")
      .def_property_readonly(
          "chess_corners",
          [](const Board& b) {
            return rows_of<3>(b.chess_corners, [](const Point3& p, double* out) { put(p, out); });
          },
          "float64 (K, 3): the inner corners of a ChArUco board's chessboard.")
      .def("view", &view, py::arg("detection"), py::arg("image"), py::kw_only(), py::arg("order") = "bgr",
           view_doc)
      .def(
          "advice", [](const Board& b, const FoundMarkers& found) { return layout_advice(b, found.markers); },
          py::arg("detection"),
          "One line when the markers are not where this ChArUco board has them, but where another layout "
          "would; else empty.")
      .def("__len__", [](const Board& b) { return b.markers.size(); })
      .def("__repr__",
           [](const Board& b) { return "<Board of " + std::to_string(b.markers.size()) + " markers>"; });
}

}  // namespace runmark::python
