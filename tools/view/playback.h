#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "frame.h"
#include "frame_source.h"
#include "input.h"

namespace runmark::cli {

/// Goes through inputs frame by frame, at the rate the videos are meant for.
class Playback {
 public:
  explicit Playback(std::vector<Input> inputs) : inputs_(std::move(inputs)) {}

  /// The next frame, of the next input where one ends. False at the end of all. Throws InputError.
  [[nodiscard]] bool forward();
  /// Leaves the rest of the current input out. False when it is the last one.
  [[nodiscard]] bool skip();
  /// The input before the current one, or the first one, from its beginning. False when it cannot be read
  /// again.
  [[nodiscard]] bool back();

  /// The frame it stands at; only after a `forward` or `back` that gave one.
  [[nodiscard]] const Frame& frame() const { return *frame_; }
  /// Whether the next frame follows by itself: not after an image.
  [[nodiscard]] bool moving() const { return inputs_[input_].moving(); }
  /// How long until the next frame is due; 0 where the source keeps time itself.
  [[nodiscard]] int milliseconds_to_next() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<Input> inputs_;
  std::size_t input_ = 0;
  std::unique_ptr<FrameSource> source_;  // of the input it stands at; none before its first frame
  std::optional<Frame> frame_;
  Clock::time_point due_;  // the next frame
};

}  // namespace runmark::cli
