#pragma once

#include <string>
#include <vector>

#include "render/geometry.h"

namespace runmark::render {

/// What is known about one marker of a rendered frame. Places and lengths are in pixels; the centre of the
/// top-left pixel is (0, 0).
struct MarkerTruth {
  int id = 0;
  Quad corners{};         ///< top-left, top-right, bottom-right, bottom-left as drawn; exact
  double side = 0;        ///< mean length of the four sides
  double size = 0;        ///< square root of the area
  double cell = 0;        ///< the shortest side over the number of cells along it
  double tilt = 0;        ///< degrees between the marker's normal and the line of sight
  double distance = 0;    ///< from the camera to its centre, in marker sides
  double margin = 0;      ///< paper of its own round the cells, in cells
  double contrast = 0;    ///< white minus black at its centre, grey levels before the tone curve
  bool occluded = false;  ///< something lies over some of its cells
  bool cut = false;       ///< one of its cells reaches to within a pixel of the picture's edge or beyond
  /// Neither required nor wrong when it is reported.
  [[nodiscard]] bool optional() const { return occluded || cut; }
};

/// What is known about a rendered frame.
struct FrameTruth {
  int width = 0;
  int height = 0;
  std::string dictionary;
  bool inverted = false;
  std::vector<MarkerTruth> markers;
  // What the whole frame has been through, see Optics, Sensor, Camera and Light.
  std::string background;
  double blur = 0;
  std::string defocus;
  double motion = 0;
  double noise = 0;
  double gamma = 1;
  int jpeg = 0;
  double distortion = 0;
  double level = 0;
  double gradient = 0;
  double vignette = 0;
  int shadows = 0;
  int lamps = 0;
};

}  // namespace runmark::render
