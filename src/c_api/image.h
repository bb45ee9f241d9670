#pragma once

#include <array>
#include <optional>

#include "c_api/number.h"
#include "runmark/image_view.h"
#include "runmark/runmark.h"

namespace runmark::c_api {

/// Nothing for a format there is not.
inline std::optional<ImageView> to_view(const runmark_image& image) {
  constexpr std::array formats{PixelFormat::grey, PixelFormat::rgb, PixelFormat::bgr};
  const unsigned format = number(image.format);
  if (format >= formats.size()) return std::nullopt;
  return ImageView{image.data, image.width, image.height, image.stride, image.step, formats[format]};
}

}  // namespace runmark::c_api
