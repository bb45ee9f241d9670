#include "stream_source.h"

#include <algorithm>
#include <string_view>

#include "byte_stream.h"
#include "errors.h"
#include "mjpeg_source.h"
#include "y4m_source.h"

namespace runmark::cli {

std::unique_ptr<FrameSource> open_stream(const std::string& name) {
  auto bytes = std::make_unique<ByteStream>(name);
  const auto start = bytes->peek(y4m_magic.size());
  if (start.empty()) throw InputError(bytes->where() + ": no data");
  if (std::ranges::equal(start.first(std::min(start.size(), y4m_magic.size())), y4m_magic))
    return std::make_unique<Y4mSource>(name, std::move(bytes));
  if (starts_mjpeg(*bytes)) return std::make_unique<MjpegSource>(name, std::move(bytes));
  throw InputError(bytes->where() + ": neither a Y4M nor an MJPEG stream");
}

}  // namespace runmark::cli
