#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace runmark {

/// A place in the image, in pixels; the centre of the top-left pixel is (0, 0).
struct Point {
  double x = 0;
  double y = 0;
};

/// One marker found in a frame.
struct Marker {
  std::string_view dictionary;  ///< the name it was asked for by; valid as long as the detector
  int id = -1;                  ///< index of the code in the dictionary
  /// Top-left, top-right, bottom-right, bottom-left of the marker as it is drawn (AprilTag families:
  /// as on the official tag images); clockwise in the image.
  std::array<Point, 4> corners{};
  int hamming = 0;  ///< bits that were corrected
  /// How far the cells are, on average, from the grey level that would flip them, as a share of the
  /// black-to-white contrast: 0 (doubtful) to 0.5 (clear).
  float margin = 0;
  bool inverted = false;  ///< white on black
  int row = -1;           ///< the frame row that had come in when the marker was given out
};

/// The first and the last row of the frame that a marker's square reaches, in pixels: a camera with a rolling
/// shutter saw it between these times the time from one row to the next.
[[nodiscard]] inline std::array<double, 2> rows_of(const Marker& marker) {
  const auto [first, last] =
      std::minmax({marker.corners[0].y, marker.corners[1].y, marker.corners[2].y, marker.corners[3].y});
  return {first, last};
}

}  // namespace runmark
