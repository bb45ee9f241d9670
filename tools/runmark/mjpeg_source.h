#pragma once

#include <memory>
#include <string>

#include "byte_stream.h"
#include "frame_source.h"

namespace runmark::cli {

/// True when a JPEG picture begins here or after a short preamble, as in a network camera's
/// multipart stream.
[[nodiscard]] bool starts_mjpeg(ByteStream& bytes);

/// JPEG pictures one after the other; bytes between them (multipart headers) are skipped.
class MjpegSource : public FrameSource {
 public:
  MjpegSource(std::string name, std::unique_ptr<ByteStream> bytes)
      : name_(std::move(name)), bytes_(std::move(bytes)) {}
  [[nodiscard]] std::optional<Frame> next() override;

 private:
  std::string name_;
  std::unique_ptr<ByteStream> bytes_;
  std::int64_t index_ = 0;
};

}  // namespace runmark::cli
