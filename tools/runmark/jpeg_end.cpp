#include "jpeg_end.h"

#include <algorithm>

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

/// SOF0 to SOF15: the segments that state a picture's size.
bool states_size(std::uint8_t marker) {
  constexpr std::uint8_t dht = 0xC4;
  constexpr std::uint8_t jpg = 0xC8;
  constexpr std::uint8_t dac = 0xCC;
  return (marker & 0xF0U) == 0xC0 && marker != dht && marker != jpg && marker != dac;
}

std::uint64_t sixteen_bits(std::span<const std::uint8_t> data, std::size_t at) {
  return std::uint64_t{data[at]} << 8U | data[at + 1];
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
      constexpr std::size_t header = 9;  // marker, length, precision, height, width
      if (at_ + (states_size(marker) ? header : 4) > data.size()) return 0;
      if (states_size(marker))
        pixels_ = std::max(pixels_, sixteen_bits(data, at_ + 5) * sixteen_bits(data, at_ + 7));
      at_ += 2 + sixteen_bits(data, at_ + 2);
    }
  }
  return 0;
}

}  // namespace runmark::cli
