#include "mjpeg_source.h"

#include <algorithm>
#include <array>

#include "errors.h"
#include "image_source.h"
#include "jpeg_end.h"

namespace runmark::cli {
namespace {

constexpr std::array<std::uint8_t, 3> picture_start{0xFF, 0xD8,
                                                    0xFF};  // SOI and the next marker's first byte
constexpr std::size_t largest_gap = 4096;
constexpr std::size_t largest_picture = std::size_t{1} << 28U;

/// Skips to the next picture; false when the stream ends or the gap is too large for one.
bool skip_to_picture(ByteStream& bytes) {
  for (std::size_t gap = 0; gap < largest_gap; ++gap) {
    const auto data = bytes.peek(picture_start.size());
    if (data.size() < picture_start.size()) return false;
    if (std::equal(picture_start.begin(), picture_start.end(), data.begin())) return true;
    bytes.skip(1);
  }
  return false;
}

}  // namespace

bool starts_mjpeg(ByteStream& bytes) { return skip_to_picture(bytes); }

std::optional<Frame> MjpegSource::next() {
  const std::string where = bytes_->where() + ": MJPEG stream: frame " + std::to_string(index_);
  if (!skip_to_picture(*bytes_)) {
    if (bytes_->peek(picture_start.size()).size() < picture_start.size()) return {};
    throw InputError(where + " does not begin with a JPEG picture");
  }
  JpegEnd end;
  std::span<const std::uint8_t> data = bytes_->peek(1);
  std::size_t length = 0;
  while ((length = end.find(data)) == 0) {
    const std::size_t before = data.size();
    if (before > largest_picture) throw InputError(where + " does not end");
    data = bytes_->peek(before + 1);
    if (data.size() == before) throw InputError(where + " breaks off");
  }
  Frame frame{name_, index_, decode_image(data.first(length), where), false};
  bytes_->skip(length);
  ++index_;
  return frame;
}

}  // namespace runmark::cli
