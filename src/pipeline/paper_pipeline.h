#pragma once

#include <vector>

#include "pattern/code_lookup.h"
#include "pipeline/contour_scan.h"
#include "pipeline/pipeline.h"
#include "threshold/fixed_threshold.h"

namespace runmark {

/// `--pipeline paper`: the seed as published. Fixed threshold, Fig. 2 filter, corner state machine, square
/// 8x8 grid compared with templates in four rotations. Corners are whole cracks.
class PaperPipeline final : public FramePipeline {
 public:
  /// @param records  crack runs alive at once, at most 65535; the hardware's are fewer
  PaperPipeline(const Options& options, const std::vector<Dictionary>& dictionaries,
                std::size_t records = 65535);

  /// The paper's grid has 8x8 cells: dictionaries of 6x6 data cells in a black border, and templates of
  /// 8x8 cells.
  [[nodiscard]] static bool can_read(const Dictionary& dictionary);

  /// What the preprocess and contour cores are told.
  [[nodiscard]] static ContourRules contour_rules(const Options& options, std::size_t records = 65535);

  void begin_frame(int width, int height) override;
  void push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) override;
  void end_frame(FrameStats& stats) override;
  [[nodiscard]] std::size_t memory() const override;

 private:
  struct Templates {
    const Dictionary* dictionary = nullptr;
    CodeLookup lookup;
  };
  void consider(const ClosedChain& chain, const GreyFrame& frame, FoundMarkers& found,
                FrameStats& stats) const;

  Options options_;
  FixedThreshold threshold_;
  std::vector<Templates> templates_;
  std::vector<std::uint8_t> grey_;
  ContourScan scan_;
  int height_ = 0;
};

}  // namespace runmark
