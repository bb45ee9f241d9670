#pragma once

namespace runmark {

/// A place in space. In a camera's frame x goes right, y down and z forwards.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

}  // namespace runmark
