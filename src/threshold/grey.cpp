#include "threshold/grey.h"

namespace runmark {

void grey_row(const std::uint8_t* pixels, int width, int step, PixelFormat format, std::uint8_t* grey) {
  for (int x = 0; x < width; ++x) grey[x] = grey_of(pixels + static_cast<std::ptrdiff_t>(x) * step, format);
}

}  // namespace runmark
