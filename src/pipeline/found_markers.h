#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "corner/quad.h"
#include "runmark/marker.h"

namespace runmark {

/// The markers of a frame in the order they were found. What is in it is never withdrawn, so the first
/// report of a physical marker stands and later ones are refused.
class FoundMarkers {
 public:
  explicit FoundMarkers(std::size_t capacity) { markers_.reserve(capacity); }

  /// Starts a frame whose region begins at pixel `origin`: quadrilaterals and markers come in pixels of the
  /// region and are kept in pixels of the frame.
  void begin_frame(Point origin) {
    origin_ = origin;
    markers_.clear();
  }

  /// Whether a marker already stands where this quadrilateral is: at the same place and of a like size.
  [[nodiscard]] bool has(const std::array<Point, 4>& corners) const;

  /// False when the list is full.
  [[nodiscard]] bool add(const Marker& marker);

  [[nodiscard]] std::span<const Marker> all() const { return markers_; }
  [[nodiscard]] std::size_t memory() const { return markers_.capacity() * sizeof(Marker); }

 private:
  Point origin_;
  std::vector<Marker> markers_;
};

}  // namespace runmark
