#pragma once

#include <opencv2/core/matx.hpp>
#include <optional>
#include <vector>

#include "runmark/marker.h"

namespace runmark {

/// From a flat board's x and y to the picture, as if the lens were straight: right near where it was fitted.
class PlaneMap {
 public:
  /// Of at least four points; nothing when they lie on a line.
  [[nodiscard]] static std::optional<PlaneMap> fit(const std::vector<Point>& board,
                                                   const std::vector<Point>& picture);
  [[nodiscard]] Point operator()(Point p) const;

 private:
  explicit PlaneMap(const cv::Matx33d& map) : map_(map) {}
  cv::Matx33d map_;
};

}  // namespace runmark
