#pragma once

#include <cstdint>
#include <vector>

#include "corner/integer_quad.h"
#include "pattern/integer_reader.h"
#include "pipeline/contour_scan.h"
#include "pipeline/pipeline.h"
#include "pipeline/row_store.h"
#include "threshold/integer_tiles.h"

namespace runmark {

/// `--pipeline hardware`: what the FPGA cores compute beyond the paper, in integers only. Light-following
/// threshold, one scale, the quadrilateral from the chain at any rotation, cells placed from all four
/// corners. Corners are in sixteenths of a pixel.
class HardwarePipeline final : public FramePipeline {
 public:
  /// @param records  crack runs alive at once, at most 65535; the hardware's are fewer
  HardwarePipeline(const Options& options, const std::vector<Dictionary>& dictionaries,
                   std::size_t records = 65535);

  /// A full square of 4x4 to 8x8 cells in a black border.
  [[nodiscard]] static bool can_read(const Dictionary& dictionary) {
    return IntegerReader::can_read(dictionary);
  }

  /// What the preprocess and contour cores are told.
  [[nodiscard]] static ContourRules contour_rules(const Options& options, std::size_t records = 65535);
  /// What the corner core is told.
  [[nodiscard]] static IntegerQuadLimits quad_limits(const Options& options);
  /// What the pattern core is told.
  [[nodiscard]] static IntegerReaderLimits reader_limits(const Options& options);

  void begin_frame(int width, int height) override;
  void push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) override;
  void end_frame(FrameStats& stats) override;
  [[nodiscard]] std::size_t memory() const override;

 private:
  void follow(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats);
  void consider(const ClosedChain& chain, const GreyFrame& frame, FoundMarkers& found,
                FrameStats& stats) const;

  Options options_;
  IntegerQuadLimits limits_;
  IntegerTiles tiles_;
  RowStore grey_;  // two bands of tiles
  ContourScan scan_;
  IntegerReader reader_;
  int height_ = 0;
};

}  // namespace runmark
