#include "camera.h"

#include <pybind11/stl.h>

#include <cmath>
#include <limits>

#include "arrays.h"
#include "runmark/camera_file.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

constexpr const char* camera_doc =
    R"(A calibrated camera, as OpenCV and ROS describe it. Lengths are in pixels; the
centre of the top-left pixel is (0, 0). In its frame x goes right, y down and z forwards.

fx, fy         focal lengths
cx, cy         where the optical axis meets the picture
width, height  of the pictures it was calibrated with; 0 when not known
lens           'plain' (k1 k2 p1 p2 k3), 'rational' (k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4) or
               'fisheye' (k1 k2 k3 k4)
distortion     as many of these as there are; the others are 0)";

Lens lens_of(const std::string& name) {
  if (name == "plain") return Lens::plain;
  if (name == "rational") return Lens::rational;
  if (name == "fisheye") return Lens::fisheye;
  throw py::value_error("lens '" + name + "': must be 'plain', 'rational' or 'fisheye'");
}

const char* name_of(Lens lens) {
  return lens == Lens::plain ? "plain" : lens == Lens::rational ? "rational" : "fisheye";
}

Camera make(double fx, double fy, double cx, double cy, int width, int height, const std::string& lens,
            const std::vector<double>& distortion) {
  Camera camera{width, height, fx, fy, cx, cy, lens_of(lens), {}};
  const auto most = static_cast<std::size_t>(coefficients_of(camera.lens));
  if (distortion.size() > most) {
    throw py::value_error("distortion: " + std::to_string(distortion.size()) + " numbers, but a " + lens +
                          " lens has " + std::to_string(most));
  }
  std::ranges::copy(distortion, camera.distortion.begin());
  if (!camera.is_valid()) throw py::value_error("the camera's numbers make no sense");
  return camera;
}

Camera value_of(Result<Camera> camera) {
  if (!camera) throw py::value_error(camera.error());
  return *std::move(camera);
}

/// Each row through `map`; NaN where it gives nothing.
template <std::size_t In, class Map>
py::array_t<double> mapped(const Numbers& rows, const char* name, const Map& map) {
  expect_shape(rows, 0, In, name);
  std::vector<Point> results;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    results.push_back(map(rows.data(i, 0)).value_or(Point{nan, nan}));
  return rows_of<2>(results, [](Point p, double* out) { put(p, out); });
}

}  // namespace

void bind_camera(py::module_& module) {
  py::class_<Camera>(module, "Camera", camera_doc)
      .def(py::init(&make), py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"), py::kw_only(),
           py::arg("width") = 0, py::arg("height") = 0, py::arg("lens") = "plain",
           py::arg("distortion") = std::vector<double>{})
      .def_static(
          "load", [](const py::object& path) { return value_of(read_camera(py::str(path))); },
          py::arg("path"), "Reads a camera file of OpenCV or of ROS (YAML).")
      .def_static(
          "parse", [](const std::string& text) { return value_of(parse_camera(text)); }, py::arg("text"),
          "Reads the text of such a file.")
      .def_readonly("width", &Camera::width, "Pixels; 0 when not known.")
      .def_readonly("height", &Camera::height, "Pixels; 0 when not known.")
      .def_property_readonly(
          "lens", [](const Camera& c) { return name_of(c.lens); }, "'plain', 'rational' or 'fisheye'.")
      .def_property_readonly(
          "matrix",
          [](const Camera& c) {
            return shaped(std::array<double, 9>{c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}, {3, 3});
          },
          "float64 (3, 3): the matrix of focal lengths and centre, as OpenCV's functions take it.")
      .def_property_readonly(
          "distortion",
          [](const Camera& c) { return py::array_t<double>(coefficients_of(c.lens), c.distortion.data()); },
          "float64: the lens's coefficients in OpenCV's order.")
      .def(
          "project",
          [](const Camera& c, const Numbers& points) {
            return mapped<3>(points, "points", [&](const double* p) {
              return c.project({p[0], p[1], p[2]});
            });
          },
          py::arg("points"),
          "points: (N, 3) in the camera's frame. Gives float64 (N, 2), their pictures in pixels; NaN for "
          "those not before the camera.")
      .def(
          "directions",
          [](const Camera& c, const Numbers& pixels) {
            return mapped<2>(pixels, "pixels", [&](const double* p) { return c.direction({p[0], p[1]}); });
          },
          py::arg("pixels"),
          "pixels: (N, 2). Gives float64 (N, 2), x and y of the point with z = 1 in the direction of each; "
          "NaN where the lens model has none.")
      .def("__repr__", [](const Camera& c) {
        return "<Camera " + std::string(name_of(c.lens)) + ", fx " + std::to_string(c.fx) + ", fy " +
               std::to_string(c.fy) + ">";
      });
}

}  // namespace runmark::python
