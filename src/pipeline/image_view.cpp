#include "runmark/image_view.h"

#include <cstdlib>

namespace runmark {

Status ImageView::check() const {
  constexpr int max_side = 65535;
  const int channels = format == PixelFormat::grey ? 1 : 3;
  const bool sides_fit = width >= 1 && width <= max_side && height >= 1 && height <= max_side;
  if (data == nullptr || !sides_fit || step < channels) return Status::bad_view;
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(width - 1) * step + channels;
  if (height > 1 && std::abs(stride) < row_bytes) return Status::bad_view;
  return Status::ok;
}

}  // namespace runmark
