#pragma once

#include <vector>

#include "corner/quad_from_chain.h"
#include "pattern/marker_reader.h"
#include "pipeline/octave.h"
#include "pipeline/pipeline.h"
#include "pipeline/row_store.h"

namespace runmark {

/// `--pipeline default`: light-following threshold at several scales, quadrilaterals at any rotation,
/// corners refined on grey edges, cells read through the homography.
class StandardPipeline final : public FramePipeline {
 public:
  StandardPipeline(const Options& options, const std::vector<Dictionary>& dictionaries);

  void begin_frame(int width, int height) override;
  void push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) override;
  void end_frame(FrameStats& stats) override;
  [[nodiscard]] std::size_t memory() const override;

 private:
  struct Scale {
    Octave octave;
    RowStore rows;  // grey rows of this scale; of the frame itself only where it must be converted
    TileRule tiles;
    QuadLimits limits;
  };
  void push_scaled(std::size_t level, const std::uint8_t* grey, int y, const GreyFrame& frame,
                   FoundMarkers& found, FrameStats& stats);
  void consider(std::size_t level, const ClosedChain& chain, const GreyFrame& frame, FoundMarkers& found,
                FrameStats& stats);

  void read(const Quad& quad, double reach, const GreyFrame& frame, FoundMarkers& found,
            FrameStats& stats) const;

  /// A quadrilateral with data cells in rows that have not come in.
  struct Waiting {
    Quad quad;
    double reach = 0;
    int row = 0;
  };

  Options options_;
  int height_ = 0;
  MarkerReader reader_;
  std::vector<Scale> scales_;
  std::size_t scales_used_ = 0;  // of this frame
  Outline outline_;              // of the chain looked at
  std::vector<Waiting> waiting_;
};

}  // namespace runmark
