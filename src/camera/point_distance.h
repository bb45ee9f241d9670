#pragma once

#include <cmath>

#include "runmark/marker.h"

namespace runmark {

[[nodiscard]] inline double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace runmark
