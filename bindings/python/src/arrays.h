#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <string>

#include "runmark/marker.h"
#include "runmark/point3.h"

namespace runmark::python {

/// Arrays of float64 that Python gave; lists become one.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// A new array with that many rows; each value fills its row.
template <std::size_t Columns, class Values, class Fill>
[[nodiscard]] pybind11::array_t<double> rows_of(const Values& values, const Fill& fill) {
  pybind11::array_t<double> result(
      {static_cast<pybind11::ssize_t>(std::size(values)), static_cast<pybind11::ssize_t>(Columns)});
  double* out = result.mutable_data();
  for (const auto& value : values) {
    fill(value, out);
    out += Columns;
  }
  return result;
}

inline void put(Point p, double* out) {
  out[0] = p.x;
  out[1] = p.y;
}
inline void put(const Point3& p, double* out) {
  out[0] = p.x;
  out[1] = p.y;
  out[2] = p.z;
}

/// The values as an array of that shape.
template <std::size_t N>
[[nodiscard]] pybind11::array_t<double> shaped(const std::array<double, N>& values,
                                               std::vector<pybind11::ssize_t> shape) {
  return pybind11::array_t<double>(std::move(shape), values.data());
}

/// Throws ValueError unless the array has that many columns and, where not 0, rows.
inline void expect_shape(const Numbers& numbers, pybind11::ssize_t rows, pybind11::ssize_t columns,
                         const char* name) {
  const bool good =
      numbers.ndim() == 2 && numbers.shape(1) == columns && (rows == 0 || numbers.shape(0) == rows);
  if (good) return;
  throw pybind11::value_error(
      std::string(name) + ": shape " + std::string(pybind11::str(numbers.attr("shape"))) +
      ", but it must be (" + (rows == 0 ? "N" : std::to_string(rows)) + ", " + std::to_string(columns) + ")");
}

}  // namespace runmark::python
