#include "jpeg_end.h"

namespace runmark::cli {
namespace {

constexpr std::uint8_t tem = 0x01;
constexpr std::uint8_t rst0 = 0xD0;
constexpr std::uint8_t rst7 = 0xD7;
constexpr std::uint8_t soi = 0xD8;
constexpr std::uint8_t eoi = 0xD9;
constexpr std::uint8_t fill = 0xFF;

/// Markers without a segment; 0 stands for a data byte 0xFF.
bool stands_alone(std::uint8_t marker) {
  return marker == 0 || marker == tem || (marker >= rst0 && marker <= rst7);
}

}  // namespace

std::size_t JpegEnd::find(std::span<const std::uint8_t> data) {
  while (at_ + 1 < data.size()) {
    if (data[at_] != 0xFF) {  // entropy-coded data
      ++at_;
      continue;
    }
    const std::uint8_t marker = data[at_ + 1];
    if (marker == fill) {
      ++at_;
    } else if (marker == eoi) {
      return at_ + 2;
    } else if (marker == soi) {
      return at_;  // the next picture: this one has lost its end
    } else if (stands_alone(marker)) {
      at_ += 2;
    } else {
      if (at_ + 3 >= data.size()) return 0;
      at_ += 2 + (static_cast<std::size_t>(data[at_ + 2]) << 8U | data[at_ + 3]);
    }
  }
  return 0;
}

}  // namespace runmark::cli
