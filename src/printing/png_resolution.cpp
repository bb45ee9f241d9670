#include "printing/png_resolution.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace runmark {
namespace {

void append_number(std::vector<unsigned char>& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<unsigned char>(value >> static_cast<unsigned>(shift)));
}

/// The CRC of the PNG specification, bit by bit: a chunk of 13 bytes needs no table.
std::uint32_t crc(const unsigned char* bytes, std::size_t count) {
  std::uint32_t c = 0xffffffffU;
  for (std::size_t i = 0; i < count; ++i) {
    c ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1U) : c >> 1U;
  }
  return c ^ 0xffffffffU;
}

}  // namespace

std::vector<unsigned char> with_resolution(const std::vector<unsigned char>& png, int dpi) {
  constexpr std::size_t header_end = 8 + 25;  // the signature and the chunk IHDR
  if (png.size() < header_end) return png;
  std::vector<unsigned char> chunk{'p', 'H', 'Y', 's'};
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
  append_number(chunk, per_metre);
  append_number(chunk, per_metre);
  chunk.push_back(1);  // the unit is the metre
  std::vector<unsigned char> result(png.begin(), png.begin() + header_end);
  append_number(result, static_cast<std::uint32_t>(chunk.size() - 4));
  result.insert(result.end(), chunk.begin(), chunk.end());
  append_number(result, crc(chunk.data(), chunk.size()));
  result.insert(result.end(), png.begin() + header_end, png.end());
  return result;
}

}  // namespace runmark
