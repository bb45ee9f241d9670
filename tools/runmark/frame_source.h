#pragma once

#include <memory>
#include <optional>

#include "frame.h"
#include "input.h"

namespace runmark::cli {

/// Where frames come from: an image, a video, a pipe, a camera. Draws on nothing outside itself, so
/// that a source may be read ahead in a thread of its own.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  virtual ~FrameSource() = default;

  /// The next frame, or nothing at the end. Throws InputError when the source is broken; the frames
  /// given out before stay good.
  [[nodiscard]] virtual std::optional<Frame> next() = 0;

  /// How many frames there will be, roughly, where that can be known.
  [[nodiscard]] virtual std::optional<std::int64_t> frame_count() const { return {}; }

  /// Whether the source itself states that it has no more than these frames.
  [[nodiscard]] virtual bool complete_after(std::int64_t /*frames*/) const { return false; }

  /// Frames a second, where the source states it.
  [[nodiscard]] virtual std::optional<double> frame_rate() const { return {}; }
};

/// Throws InputError when the input cannot be opened.
[[nodiscard]] std::unique_ptr<FrameSource> open_source(const Input& input);

}  // namespace runmark::cli
