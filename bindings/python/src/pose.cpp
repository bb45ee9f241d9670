#include "pose.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "detection.h"
#include "image.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

constexpr const char* pose_doc = R"(The pose of a marker before a camera.

marker  a Marker, or its corners: (4, 2), x, y in pixels, top-left, top-right, bottom-right, bottom-left as drawn
size    the side of the marker, in any unit; translations come in it
camera  a Camera
image   the frame it was found in, which says how sure the corners are; as for Detector.detect
order   'bgr' or 'rgb'

The marker's frame has its origin in the marker's middle, x along the upper side to the right, y down, z into the
sheet. Raises ValueError when no pose explains the corners.)";

Marker marker_from(const py::object& given) {
  if (py::isinstance<FoundMarker>(given)) return given.cast<FoundMarker>().marker;
  const Numbers corners = Numbers::ensure(given);
  if (!corners) {
    PyErr_Clear();
    throw py::type_error("marker: a Marker or its corners are wanted");
  }
  expect_shape(corners, 4, 2, "marker");
  Marker marker;
  marker.dictionary = "corners";
  marker.id = 0;
  for (py::ssize_t i = 0; i < 4; ++i) {
    marker.corners[static_cast<std::size_t>(i)] = {corners.at(i, 0), corners.at(i, 1)};
  }
  return marker;
}

PoseEstimate pose_of(const py::object& marker, double size, const Camera& camera, const py::object& image,
                     const std::string& order) {
  const Marker m = marker_from(marker);
  if (image.is_none()) return value_of(runmark::pose(m, size, camera));
  const ArrayView array = view_of(image, order, "image");
  return value_of(runmark::pose(m, size, camera, corner_covariance(m, array.view)));
}

py::array_t<double> matrix_of(const PoseSolution& s) {
  const auto& r = s.pose.rotation;
  const Point3& t = s.pose.translation;
  return shaped(
      std::array<double, 16>{r[0], r[1], r[2], t.x, r[3], r[4], r[5], t.y, r[6], r[7], r[8], t.z, 0, 0, 0, 1},
      {4, 4});
}

py::array_t<double> vector_of(const Point3& p) { return shaped(std::array<double, 3>{p.x, p.y, p.z}, {3}); }

}  // namespace

PoseEstimate value_of(Result<PoseEstimate> estimate) {
  if (!estimate) throw py::value_error(estimate.error());
  return *std::move(estimate);
}

void bind_pose(py::module_& module) {
  py::class_<PoseSolution>(module, "Pose",
                           "Where an object stands: takes points of its frame to the camera's.")
      .def_property_readonly(
          "rotation",
          [](const PoseSolution& s) {
            return shaped(s.pose.rotation, {3, 3});
          },
          "float64 (3, 3): the rotation matrix.")
      .def_property_readonly(
          "translation", [](const PoseSolution& s) { return vector_of(s.pose.translation); },
          "float64 (3,): of the object's origin, in the unit of its size.")
      .def_property_readonly("matrix", &matrix_of, "float64 (4, 4): both, for homogeneous coordinates.")
      .def_property_readonly(
          "rotation_vector", [](const PoseSolution& s) { return vector_of(rotation_vector(s.pose)); },
          "float64 (3,): OpenCV's rvec, the axis, as long as the angle in radians.")
      .def_property_readonly(
          "quaternion", [](const PoseSolution& s) { return shaped(quaternion(s.pose), {4}); },
          "float64 (4,): x, y, z, w.")
      .def_readonly("error", &PoseSolution::error,
                    "Root mean square distance of the projected corners from those seen, in pixels.")
      .def_property_readonly(
          "covariance",
          [](const PoseSolution& s) {
            return shaped(s.covariance, {6, 6});
          },
          "float64 (6, 6): x, y, z of the translation in the unit of the size, then the rotation about the "
          "camera's x, y and z axes in radians, as in ROS.")
      .def("__repr__", [](const PoseSolution& s) {
        const Point3& t = s.pose.translation;
        return "<Pose at " + std::to_string(t.x) + ", " + std::to_string(t.y) + ", " + std::to_string(t.z) +
               ">";
      });
  py::class_<PoseEstimate>(
      module, "PoseEstimate",
      "What corners say of a pose: something flat often has two that explain them almost alike.")
      .def_readonly("best", &PoseEstimate::best, "The Pose that explains the corners best.")
      .def_readonly("other", &PoseEstimate::other, "The other one, or None.")
      .def_readonly("ambiguity", &PoseEstimate::ambiguity,
                    "Near 0 best is right, near 1 either may be; 0 without other.");
  module.def("pose", pose_of, py::arg("marker"), py::arg("size"), py::arg("camera"),
             py::arg("image") = py::none(), py::kw_only(), py::arg("order") = "bgr", pose_doc);
}

}  // namespace runmark::python
