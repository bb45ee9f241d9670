#pragma once

#include <memory>
#include <string>

#include "frame_source.h"

namespace runmark::cli {

/// A Y4M or MJPEG stream from "-" or a file; its first bytes say which. Throws InputError.
[[nodiscard]] std::unique_ptr<FrameSource> open_stream(const std::string& name);

}  // namespace runmark::cli
