#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/light.h"
#include "render/optics.h"
#include "render/plane.h"
#include "render/sensor.h"
#include "render/surface.h"
#include "render/truth.h"

namespace runmark::render {

/// A marker of the scene: its surface is one of those of the scene, with a MarkerPrint on it.
struct PlacedMarker {
  std::size_t surface = 0;
  int id = 0;
  int width = 0;  ///< cells along the side of the detected square
};

/// All that a picture is made of. A value: copy it, change one thing, render it again.
struct Scene {
  std::string dictionary;
  bool inverted = false;
  std::string background;  ///< what the wall is, in a word; for the truth only
  Camera camera;
  std::vector<Surface> surfaces;  ///< the farthest first
  std::vector<PlacedMarker> markers;
  Light light;
  Optics optics;
  Sensor sensor;
  std::uint64_t tints = 0;  ///< seed of the colours
};

struct RenderedFrame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;  ///< width * height, row-major
  FrameTruth truth;
};

/// The picture of a scene and the exact truth about it.
[[nodiscard]] RenderedFrame render(const Scene& scene);

/// The truth alone.
[[nodiscard]] FrameTruth truth_of(const Scene& scene);

}  // namespace runmark::render
