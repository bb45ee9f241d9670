#pragma once

#include <pybind11/numpy.h>

#include <string_view>

#include "runmark/image_view.h"

namespace runmark::python {

/// A view of an array's own memory, and what keeps that memory alive.
struct ArrayView {
  ImageView view;
  pybind11::array memory;
};

/// uint8 of shape (H, W), (H, W, 1), (H, W, 3) or (H, W, 4), with any strides. Nothing is copied unless
/// pixels share memory (broadcasts, overlapping windows) or a pixel's channels do not lie side by side; those
/// become a contiguous copy. Throws TypeError or ValueError that starts with `name`.
/// @param order  "bgr" or "rgb": which comes first where there are colours
[[nodiscard]] ArrayView view_of(const pybind11::object& image, std::string_view order, const char* name);

}  // namespace runmark::python
