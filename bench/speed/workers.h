#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/speed/frames.h"

namespace runmark::bench {

/// Something to be timed on one frame.
struct Worker {
  std::string name;
  int repeats = 1;  ///< calls in one measurement, so that the clock's own cost does not show
  std::function<void()> work;
};

/// The contender of that name (bench/peers/reader.h) on a frame that outlives it.
[[nodiscard]] Worker reader_for(const char* name, const TimedFrame& frame);

/// For one frame: runmark, OpenCV's ArUco (sub-pixel), AprilTag 3 (decimate 1 and 2), runmark fed row by row,
/// then the floor and OpenCV's building blocks of a detector: a copy of the frame (in cache), threshold,
/// adaptiveThreshold, connectedComponents, findContours. The frame must outlive them.
[[nodiscard]] std::vector<Worker> workers_for(const TimedFrame& frame);

}  // namespace runmark::bench
