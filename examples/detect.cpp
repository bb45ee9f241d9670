// Finds the markers of one picture: detect PICTURE.pgm
#include <exception>
#include <iostream>
#include <stdexcept>

#include "pgm.h"
#include "runmark/detector.h"

// README.md shows the lines between the marks; a test compares them.
// [readme]
void print_markers(const Picture& picture) {
  auto dictionary = runmark::builtin_dictionary("tag36h11");
  auto detector = runmark::Detector::create({.max_width = picture.width, .max_height = picture.height},
                                            {*std::move(dictionary)});
  if (!detector) throw std::runtime_error(detector.error());
  const auto view =
      runmark::ImageView::grey(picture.grey.data(), picture.width, picture.height, picture.width);
  for (const runmark::Marker& marker : detector->detect(view)) {
    const auto [x, y] = marker.corners[0];
    std::cout << marker.dictionary << ' ' << marker.id << ": top-left corner " << x << ", " << y << '\n';
  }
}
// [readme]

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: detect PICTURE.pgm");
    print_markers(read_pgm(argv[1]));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
