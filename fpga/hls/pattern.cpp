#include <algorithm>
#include <bit>
#include <utility>

#include "cores.h"
#include "pattern/square_grid.h"
#include "threshold/fixed_threshold.h"

namespace runmark::hls_form {
namespace {

struct Quad {
  CrackPoint corner[4];
  int bottom = 0;
  bool hole = false;
};

Quad read_quad(Word first, QuadStream& quads) {
  const Word second = quads.read();
  const Word rest = quads.read();
  Quad quad{{place_of(first, 0), place_of(first, 1), place_of(second, 0), place_of(second, 1)},
            static_cast<int>(field(rest, 0, 16)),
            field(rest, 16, 1) != 0};
  if (quad.hole) {  // followed the other way round
    std::swap(quad.corner[0], quad.corner[3]);
    std::swap(quad.corner[1], quad.corner[2]);
  }
  return quad;
}

int cross(CrackPoint a, CrackPoint b, CrackPoint c, CrackPoint d) {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
}

bool is_good(const Quad& quad, const Settings& settings) {
  bool good = true;
  for (int i = 0; i < 4; ++i) {
#pragma HLS UNROLL factor = 1
    good =
        good && cross(quad.corner[i], quad.corner[(i + 1) % 4], quad.corner[i], quad.corner[(i + 2) % 4]) > 0;
  }
  const int area = cross(quad.corner[0], quad.corner[2], quad.corner[1], quad.corner[3]);
  return good && area >= settings.min_area && area <= settings.max_area;
}

PixelPosition cell(const Quad& quad, int number) {
  return grid_sample(quad.corner[0], quad.corner[1], number % grid_side, number / grid_side);
}

bool lies_inside(const Quad& quad, const Settings& settings) {
  bool inside = true;
  for (int i = 0; i < grid_side * grid_side; ++i) {
#pragma HLS PIPELINE II = 1
    const PixelPosition p = cell(quad, i);
    inside = inside && p.x >= 0 && p.y >= 0 && p.x < settings.width && p.y < settings.height;
  }
  return inside;
}

/// 36 cells of a marker seen a quarter turn back.
std::uint64_t turned(std::uint64_t code) {
  std::uint64_t result = 0;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
#pragma HLS UNROLL
      result = result << 1 | (code >> (35 - (6 * column + 5 - row)) & 1);
    }
  }
  return result;
}

}  // namespace

void pattern(const Settings& settings, const std::uint64_t codes[max_codes], QuadStream& quads,
             ReadStream& reads, GreyStream& answers, MarkerStream& markers) {
#pragma HLS INTERFACE s_axilite port = settings
#pragma HLS INTERFACE bram port = codes
#pragma HLS INTERFACE axis port = quads
#pragma HLS INTERFACE axis port = reads
#pragma HLS INTERFACE axis port = answers
#pragma HLS INTERFACE axis port = markers
  const FixedThreshold fixed{settings.level, settings.above_is_dark};
  for (Word word = quads.read(); word != frame_end; word = quads.read()) {
#pragma HLS PIPELINE off
    const Quad quad = read_quad(word, quads);
    if (!is_good(quad, settings) || !lies_inside(quad, settings)) continue;

    for (int i = 0; i < grid_side * grid_side; ++i) {
#pragma HLS PIPELINE II = 1
      const PixelPosition p = cell(quad, i);
      // The square may reach a little below the rows that have come in.
      const int y = std::min(p.y, quad.bottom + 1);
      reads.write(static_cast<std::uint32_t>(p.x) | static_cast<std::uint32_t>(y) << 16);
    }
    std::uint64_t code = 0;
    int border_errors = 0;
    for (int i = 0; i < grid_side * grid_side; ++i) {
#pragma HLS PIPELINE II = 1
      const bool white = fixed.dark(answers.read()) == quad.hole;
      const int column = i % grid_side;
      const int row = i / grid_side;
      if (column == 0 || column == grid_side - 1 || row == 0 || row == grid_side - 1) {
        border_errors += white ? 1 : 0;
      } else {
        code = code << 1 | (white ? 1U : 0U);
      }
    }
    bool found = false;
    for (int i = 0; i < 4 * settings.codes && !found; ++i) {
#pragma HLS PIPELINE II = 1
      const int rotation = i / settings.codes;
      const int id = i % settings.codes;
      if (i > 0 && id == 0) code = turned(code);
      const int errors = border_errors + std::popcount(code ^ codes[id]);
      found = errors <= settings.max_errors;
      if (!found) continue;
      const auto corner = [&](int k) { return quad.corner[(k + rotation) % 4]; };
      markers.write(places_word(corner(0), corner(1)));
      markers.write(places_word(corner(2), corner(3)));
      markers.write(marker_word(static_cast<unsigned>(id), static_cast<unsigned>(errors), quad.hole));
    }
  }
  markers.write(frame_end);
}

}  // namespace runmark::hls_form
