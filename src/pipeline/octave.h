#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/contour_scan.h"
#include "threshold/tile_threshold.h"
#include "threshold/tiles_fast.h"

namespace runmark {

/// One scale of the light-following pipelines: grey rows in, closed chains out. A row's contours are
/// followed when the band of tiles below it is complete.
class Octave {
 public:
  Octave(int max_width, const ContourRules& rules) : threshold_(max_width), scan_(max_width, rules) {}

  void begin_frame(int width, int height, const TileRule& rule) {
    width_ = width;
    height_ = height;
    rows_ = 0;
    threshold_.begin_frame(width, rule);
    scan_.begin_frame(width, height);
  }

  /// Takes the next grey row, which must stay readable for eight more calls.
  template <class Sink>
  void push(const std::uint8_t* grey, Sink&& sink) {
    const auto slot = static_cast<std::size_t>(rows_ % tile_side);
    fresh_[slot] = grey;
    ++rows_;
    if (rows_ < height_ && slot + 1 < tile_side) return;
    const std::size_t filled = slot + 1;
    for (std::size_t i = filled; i < tile_side; ++i) fresh_[i] = grey;
    threshold_.add_band(fresh_);
    if (rows_ > tile_side) follow(tile_side, sink);
    waiting_ = fresh_;
    if (rows_ == height_) {
      threshold_.finish();
      follow(filled, sink);
    }
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  void add_counts(FrameStats& stats) const { scan_.add_counts(stats); }
  [[nodiscard]] std::size_t memory() const { return threshold_.memory() + scan_.memory(); }

 private:
  template <class Sink>
  void follow(std::size_t rows, Sink&& sink) {
    for (std::size_t i = 0; i < rows; ++i) {
      fast::threshold_row(waiting_[i], width_, threshold_.levels(), scan_.next_row());
      scan_.advance(sink);
    }
  }

  int width_ = 0;
  int height_ = 0;
  int rows_ = 0;
  TileBand fresh_{};    // the band being filled
  TileBand waiting_{};  // the band whose levels the fresh one completes
  TileThreshold threshold_;
  ContourScan scan_;
};

}  // namespace runmark
