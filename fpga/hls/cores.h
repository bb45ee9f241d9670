#pragma once

#include <cstdint>

#include "stream.h"
#include "words.h"

// The paper's five cores as functions for high-level synthesis, and all five as one dataflow region. Each
// call is one frame. They are wrapped round the plain cores of src/ and give the same results.
namespace runmark::hls_form {

inline constexpr int max_width = 640;
inline constexpr int max_height = 480;
inline constexpr int max_records = 1023;
inline constexpr int max_codes = 1024;

/// What the registers hold.
struct Settings {
  int width = 0;   ///< 1 to max_width
  int height = 0;  ///< 1 to max_height
  int level = 128;
  bool above_is_dark = false;
  bool rgb = false;  ///< pixels are red, green, blue from the low byte up; else grey in the low byte
  std::uint8_t cases = 63;
  bool eight = true;
  unsigned max_turns = 30;
  unsigned min_height = 0;
  bool holes = false;
  int corner_offset = 5;
  int min_area = 0;  ///< of a quad, in half pixels
  int max_area = 0;
  int max_errors = 0;
  int codes = 0;
};

using PixelStream = hls::stream<std::uint32_t, 32>;
using GreyStream = hls::stream<std::uint8_t, 32>;
using BitStream = hls::stream<std::uint8_t, 32>;
using RunStream = hls::stream<Word, 512>;
using ChainStream = hls::stream<Word, 64>;
using QuadStream = hls::stream<Word, 64>;
using ReadStream = hls::stream<std::uint32_t, 64>;  ///< x and y << 16 of a pixel to be read
using MarkerStream = hls::stream<Word, 16>;

/// width * height pixels in; dark or light and the grey level out.
void threshold(const Settings& settings, PixelStream& pixels, BitStream& dark, GreyStream& grey);

/// Border, 3x3 filter and crack runs: a window and three line buffers, a pixel a clock.
void preprocess(const Settings& settings, BitStream& dark, RunStream& runs);

/// Crack runs to closed chains, whose records are handed on by value.
void contour(const Settings& settings, RunStream& runs, ChainStream& chains);

/// Closed chains to those with four corners.
void corner(const Settings& settings, ChainStream& chains, QuadStream& quads);

/// Quads to markers. Asks for 64 pixels of each: answers come in the same order, and only once the pixel's
/// row has been written to where they are read. `codes` are 36 cells, the top-left one in bit 35, 1 = white.
void pattern(const Settings& settings, const std::uint64_t codes[max_codes], QuadStream& quads,
             ReadStream& reads, GreyStream& answers, MarkerStream& markers);

/// The five in a row.
void paper_cores(const Settings& settings, const std::uint64_t codes[max_codes], PixelStream& pixels,
                 GreyStream& grey, ReadStream& reads, GreyStream& answers, MarkerStream& markers);

}  // namespace runmark::hls_form
