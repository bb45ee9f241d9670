#include "cores.h"
#include "threshold/fixed_threshold.h"
#include "threshold/grey.h"

namespace runmark::hls_form {

void threshold(const Settings& settings, PixelStream& pixels, BitStream& dark, GreyStream& grey) {
#pragma HLS INTERFACE s_axilite port = settings
#pragma HLS INTERFACE axis port = pixels
#pragma HLS INTERFACE axis port = dark
#pragma HLS INTERFACE axis port = grey
  const FixedThreshold fixed{settings.level, settings.above_is_dark};
  const int count = settings.width * settings.height;
  for (int i = 0; i < count; ++i) {
#pragma HLS PIPELINE II = 1
    const std::uint32_t pixel = pixels.read();
    const unsigned low = pixel & 255;
    const auto level =
        static_cast<std::uint8_t>(settings.rgb ? grey_of(low, pixel >> 8 & 255, pixel >> 16 & 255) : low);
    dark.write(fixed.dark(level) ? 1 : 0);
    grey.write(level);
  }
}

}  // namespace runmark::hls_form
