#pragma once

#include <cstdint>

namespace runmark {

/// Grey levels in sixteenths, of the cells of one marker.
using FineGrey = std::int32_t;

/// The light on a marker, in integers: sums over the cells of its border and those just outside it, from
/// which follow the level half-way between black and white, as a plane over the marker, and the contrast.
class IntegerLight {
 public:
  /// @param width  cells along the side of the square, 6 to 10
  explicit IntegerLight(int width);

  /// The grey level in the middle of cell (column, row): in the border ring or the ring outside it.
  void add(int column, int row, FineGrey grey);
  /// When all are in: the plane.
  void finish();

  /// White less black.
  [[nodiscard]] FineGrey contrast() const { return contrast_; }
  /// How far above half-way a grey level in the middle of a cell is; positive is white.
  [[nodiscard]] FineGrey above(int column, int row, FineGrey grey) const {
    return grey - level_ - ((across_ * centred(column) + down_ * centred(row)) >> 8);
  }

 private:
  /// A cell's middle from that of the marker, in half cells.
  [[nodiscard]] int centred(int cell) const { return 2 * cell + 1 - width_; }

  int width_;
  std::int64_t black_ = 0;  // sums of the border ring and of the ring outside it
  std::int64_t white_ = 0;
  std::int64_t moment_x_ = 0;  // of both
  std::int64_t moment_y_ = 0;
  FineGrey level_ = 0;
  FineGrey contrast_ = 0;
  std::int32_t across_ = 0;  // of the plane, for each half cell, in 1/256
  std::int32_t down_ = 0;
};

}  // namespace runmark
