#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "frame_source.h"

namespace runmark::cli {

/// An image file: one frame. Pixels as stored: an EXIF orientation is not applied.
class ImageSource : public FrameSource {
 public:
  explicit ImageSource(std::string path) : path_(std::move(path)) {}
  [[nodiscard]] std::optional<Frame> next() override;
  [[nodiscard]] std::optional<std::int64_t> frame_count() const override { return 1; }

 private:
  std::string path_;
  bool given_ = false;
};

/// Reads an image file as 8-bit grey or BGR. Throws InputError.
[[nodiscard]] cv::Mat read_image(const std::string& path);

/// Decodes an image file's bytes as 8-bit grey or BGR: 16-bit samples lose their lower byte, what is
/// transparent shows a white page. Errors begin with `where`.
[[nodiscard]] cv::Mat decode_image(std::span<const std::uint8_t> bytes, const std::string& where);

}  // namespace runmark::cli
