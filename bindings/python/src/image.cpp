#include "image.h"

#include <cstdint>
#include <string>

namespace py = pybind11;

namespace runmark::python {
namespace {

constexpr py::ssize_t most_side = 65535;

std::string shape_of(const py::array& array) { return py::str(array.attr("shape")); }

PixelFormat format_of(std::string_view order) {
  if (order == "bgr") return PixelFormat::bgr;
  if (order == "rgb") return PixelFormat::rgb;
  throw py::value_error("order '" + std::string(order) + "': must be 'bgr' or 'rgb'");
}

py::array checked(const py::object& image, const char* name) {
  py::array array = py::array::ensure(image);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": not an array");
  }
  if (array.dtype().kind() != 'u' || array.itemsize() != 1) {
    throw py::type_error(std::string(name) + ": dtype " + std::string(py::str(array.dtype())) +
                         ", but it must be uint8");
  }
  const bool shaped =
      array.ndim() == 2 ||
      (array.ndim() == 3 && (array.shape(2) == 1 || array.shape(2) == 3 || array.shape(2) == 4));
  const bool sized = shaped && array.shape(0) >= 1 && array.shape(0) <= most_side && array.shape(1) >= 1 &&
                     array.shape(1) <= most_side;
  if (!sized) {
    throw py::value_error(
        std::string(name) + ": shape " + shape_of(array) +
        ", but it must be (H, W), (H, W, 1), (H, W, 3) or (H, W, 4) with sides from 1 to 65535");
  }
  return array;
}

/// The array as the library sees it; `Status::ok` is for the caller to check.
ImageView plain_view(const py::array& array, PixelFormat colours) {
  ImageView view;
  view.data = static_cast<const std::uint8_t*>(array.data());
  view.height = static_cast<int>(array.shape(0));
  view.width = static_cast<int>(array.shape(1));
  view.format = array.ndim() == 3 && array.shape(2) > 1 ? colours : PixelFormat::grey;
  const int channels = view.format == PixelFormat::grey ? 1 : 3;
  // NumPy gives sides of one pixel any stride.
  const py::ssize_t step = view.width == 1 ? channels : array.strides(1);
  view.step = static_cast<int>(step);
  view.stride = view.height == 1 ? static_cast<std::ptrdiff_t>(channels) * view.width : array.strides(0);
  if (view.step != step) view.data = nullptr;  // does not fit
  if (channels == 1) return view;
  if (array.strides(2) == -1) {  // image[:, :, ::-1]
    view.data -= 2;
    view.format = colours == PixelFormat::bgr ? PixelFormat::rgb : PixelFormat::bgr;
  } else if (array.strides(2) != 1) {
    view.data = nullptr;
  }
  return view;
}

}  // namespace

ArrayView view_of(const py::object& image, std::string_view order, const char* name) {
  const PixelFormat colours = format_of(order);
  py::array array = checked(image, name);
  ImageView view = plain_view(array, colours);
  if (view.check() != Status::ok) {
    array = py::array_t<std::uint8_t, py::array::c_style>::ensure(array.attr("copy")("C"));
    view = plain_view(array, colours);
  }
  return {view, std::move(array)};
}

}  // namespace runmark::python
