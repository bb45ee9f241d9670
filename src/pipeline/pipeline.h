#pragma once

#include <cstdint>

#include "pattern/grey_frame.h"
#include "runmark/detector.h"

namespace runmark {

/// What an option that leaves the choice to the pipeline comes to.
[[nodiscard]] constexpr Connectivity or_own(Connectivity asked, Connectivity own) {
  return asked == Connectivity::standard ? own : asked;
}
[[nodiscard]] constexpr std::uint8_t or_own(std::uint8_t filter, std::uint8_t own) {
  return filter == filter_standard ? own : filter;
}

class FoundMarkers;

/// The five cores put together in one way, fed a row at a time.
class FramePipeline {
 public:
  virtual ~FramePipeline() = default;
  virtual void begin_frame(int width, int height) = 0;
  /// Row `frame.height - 1` has come in. New markers go to `found`, in pixels of the frame.
  virtual void push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) = 0;
  /// The frame is complete: the counts of the whole frame.
  virtual void end_frame(FrameStats& stats) = 0;
  [[nodiscard]] virtual std::size_t memory() const = 0;
};

}  // namespace runmark
