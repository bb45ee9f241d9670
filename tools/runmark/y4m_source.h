#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "byte_stream.h"
#include "errors.h"
#include "frame_source.h"

namespace runmark::cli {

inline constexpr std::string_view y4m_magic = "YUV4MPEG2 ";

/// Uncompressed video as ffmpeg and mjpegtools write it to pipes: only the luma plane is used, as it
/// is stored. 8 bits; 4:2:0, 4:1:1, 4:2:2, 4:4:4, 4:4:4 with alpha, mono.
/// Source of the format: the yuv4mpeg(5) manual page of mjpegtools.
class Y4mSource : public FrameSource {
 public:
  /// Reads the stream's header. Throws InputError.
  Y4mSource(std::string name, std::unique_ptr<ByteStream> bytes);
  [[nodiscard]] std::optional<Frame> next() override;
  [[nodiscard]] std::optional<double> frame_rate() const override { return frame_rate_; }

 private:
  /// Up to the line feed, which is skipped as well.
  std::string read_line();
  void read_parameter(std::string_view parameter);
  void set_colour_space(std::string_view name);
  [[nodiscard]] InputError error(const std::string& what) const;

  std::string name_;
  std::unique_ptr<ByteStream> bytes_;
  int width_ = 0;
  int height_ = 0;
  std::optional<double> frame_rate_;
  std::string colour_space_ = "420";
  std::size_t chroma_bytes_ = 0;  ///< of each frame, after its luma
  std::int64_t index_ = 0;
};

}  // namespace runmark::cli
