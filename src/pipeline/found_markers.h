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
  /// `rejected_capacity` 0: rejected squares are not kept.
  explicit FoundMarkers(std::size_t capacity, std::size_t rejected_capacity = 0) {
    markers_.reserve(capacity);
    rejected_.reserve(rejected_capacity);
  }

  /// Starts a frame whose region begins at pixel `origin`: quadrilaterals and markers come in pixels of the
  /// region and are kept in pixels of the frame.
  void begin_frame(Point origin) {
    origin_ = origin;
    markers_.clear();
    rejected_.clear();
  }

  /// Whether a marker already stands where this quadrilateral is: at the same place and of a like size.
  [[nodiscard]] bool has(const std::array<Point, 4>& corners) const;

  /// False when the list is full.
  [[nodiscard]] bool add(const Marker& marker);

  /// No marker was read in this quadrilateral.
  void reject(const std::array<Point, 4>& corners) {
    if (rejected_.size() < rejected_.capacity()) keep_rejected(corners);
  }
  /// Takes back what was rejected at one scale and read at another.
  void end_frame();

  [[nodiscard]] std::span<const Marker> all() const { return markers_; }
  [[nodiscard]] std::span<const std::array<Point, 4>> rejected() const { return rejected_; }
  [[nodiscard]] std::size_t memory() const {
    return markers_.capacity() * sizeof(Marker) + rejected_.capacity() * sizeof(rejected_[0]);
  }

 private:
  void keep_rejected(const std::array<Point, 4>& corners);

  Point origin_;
  std::vector<Marker> markers_;
  std::vector<std::array<Point, 4>> rejected_;  // in pixels of the frame
};

}  // namespace runmark
