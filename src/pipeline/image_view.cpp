#include "runmark/image_view.h"

#include <cstdlib>

namespace runmark {

Status ImageView::check() const {
  constexpr int max_side = 65535;
  const int channels = format == PixelFormat::grey ? 1 : 3;
  const bool sides_fit = width >= 1 && width <= max_side && height >= 1 && height <= max_side;
  if (data == nullptr || !sides_fit || std::abs(step) < channels) return Status::bad_view;
  const auto across = static_cast<std::ptrdiff_t>(width - 1) * std::abs(step) + channels;
  const auto down = static_cast<std::ptrdiff_t>(height - 1) * std::abs(stride) + channels;
  const bool rows_apart = height == 1 || std::abs(stride) >= across;
  const bool columns_apart = std::abs(stride) >= channels && std::abs(step) >= down;
  return rows_apart || columns_apart ? Status::ok : Status::bad_view;
}

}  // namespace runmark
