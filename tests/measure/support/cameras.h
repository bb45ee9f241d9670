#pragma once

#include <vector>

#include "runmark/camera.h"

namespace runmark::test {

/// Cameras with lenses of every kind, about as strong as they come.
inline std::vector<Camera> cameras() {
  const auto camera = [](Lens lens, std::array<double, 12> distortion) {
    return Camera{640, 480, 520, 515, 331.5, 236.25, lens, distortion};
  };
  return {
      camera(Lens::plain, {}),
      camera(Lens::plain, {-0.28, 0.09, 0.001, -0.0015, -0.01}),
      camera(Lens::plain, {0.12, -0.2, 0.0004, -0.002, 0.08}),
      camera(Lens::rational, {1.2, 0.35, 0.0005, -0.0003, 0.02, 1.5, 0.6, 0.06}),
      camera(Lens::rational, {-0.2, 0.05, 0.001, 0.002, 0.01, 0.05, 0.01, 0, 0.001, -0.002, 0.0015, 0.001}),
      camera(Lens::fisheye, {}),
      camera(Lens::fisheye, {-0.03, 0.012, -0.008, 0.002})};
}

}  // namespace runmark::test
