#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "runmark/detector.h"

namespace runmark::python {

using Dictionaries = std::shared_ptr<const std::vector<Dictionary>>;

/// A marker that outlives its detector.
struct FoundMarker {
  Marker marker;  ///< its name is one of those in `dictionaries`
  Dictionaries dictionaries;
};

/// What one frame gave: a sequence of markers, and the same as arrays.
struct FoundMarkers {
  int width = 0;
  int height = 0;
  std::vector<Marker> markers;
  std::vector<std::array<Point, 4>> rejected;
  FrameStats stats;
  Dictionaries dictionaries;

  void add(std::span<const Marker> found);
  /// Also what is known only when the frame is complete.
  void finish(const Detector& detector);
};

void bind_detection(pybind11::module_& module);

}  // namespace runmark::python
