// Writes the picture that the examples are tried on: a grey 320x240 scene with tag36h11 markers 7 (above) and
// 42 (below, at the right): draw_sample OUT.pgm
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <vector>

#include "render/draw_marker.h"
#include "runmark/dictionary.h"

namespace {

constexpr int width = 320;
constexpr int height = 240;

void paste(std::vector<std::uint8_t>& scene, const runmark::MarkerDrawing& drawing, int left, int top) {
  for (int y = 0; y < drawing.side; ++y) {
    std::copy_n(drawing.grey.begin() + static_cast<std::ptrdiff_t>(y) * drawing.side, drawing.side,
                scene.begin() + static_cast<std::ptrdiff_t>(top + y) * width + left);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: draw_sample OUT.pgm\n";
    return 2;
  }
  const auto dictionary = runmark::builtin_dictionary("tag36h11");
  if (!dictionary) {
    std::cerr << dictionary.error() << '\n';
    return 2;
  }
  std::vector<std::uint8_t> scene(std::size_t{width} * height, 190);
  paste(scene, runmark::draw_marker(*dictionary, 7, 6, 1), 40, 20);
  paste(scene, runmark::draw_marker(*dictionary, 42, 8, 1), 200, 130);
  std::ofstream file(argv[1], std::ios::binary);
  file << "P5\n" << width << ' ' << height << "\n255\n";
  file.write(reinterpret_cast<const char*>(scene.data()), static_cast<std::streamsize>(scene.size()));
  return file ? 0 : 2;
}
