#include "runmark/image_view.h"

#include <cstdint>

namespace runmark {
namespace {

/// The distance, whatever its direction, also of the least number there is.
std::uint64_t size_of(std::ptrdiff_t bytes) {
  const auto unsigned_bytes = static_cast<std::uint64_t>(bytes);
  return bytes < 0 ? 0 - unsigned_bytes : unsigned_bytes;
}

}  // namespace

Status ImageView::check() const {
  constexpr int max_side = 65535;
  const std::uint64_t channels = format == PixelFormat::grey ? 1 : 3;
  const bool sides_fit = width >= 1 && width <= max_side && height >= 1 && height <= max_side;
  const std::uint64_t pixel = size_of(step);
  const std::uint64_t line = size_of(stride);
  if (data == nullptr || !sides_fit || pixel < channels) return Status::bad_view;
  const auto columns = static_cast<std::uint64_t>(width - 1);
  const auto rows = static_cast<std::uint64_t>(height - 1);
  const bool rows_apart = rows == 0 || line >= columns * pixel + channels;
  const bool columns_apart = line >= channels && line <= pixel && pixel >= rows * line + channels;
  return rows_apart || columns_apart ? Status::ok : Status::bad_view;
}

}  // namespace runmark
