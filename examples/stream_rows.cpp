// A rolling-shutter camera hands over a picture a few rows at a time, over most of the frame time. The
// detector takes the rows as they come, so a marker is known while the rest of the frame is still being
// read out: stream_rows PICTURE.pgm [ROWS_AT_A_TIME]
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "pgm.h"
#include "runmark/detector.h"

namespace {

void check(runmark::Status status) {
  if (status != runmark::Status::ok) throw std::runtime_error(std::string(runmark::describe(status)));
}

void stream(const Picture& picture, int rows_at_a_time) {
  auto dictionary = runmark::builtin_dictionary("tag36h11");
  if (!dictionary) throw std::runtime_error(dictionary.error());
  auto detector = runmark::Detector::create({.max_width = picture.width, .max_height = picture.height},
                                            {*std::move(dictionary)});
  if (!detector) throw std::runtime_error(detector.error());

  // 30 frames/s; the read-out takes nine tenths of the frame time.
  const double row_ms = 1000.0 / 30 * 0.9 / picture.height;
  const auto frame =
      runmark::ImageView::grey(picture.grey.data(), picture.width, picture.height, picture.width);
  std::size_t reported = 0;
  const auto report = [&](int rows) {
    // What was given out is never withdrawn: only the new ones at the back need a look.
    for (const runmark::Marker& marker : detector->markers().subspan(reported)) {
      std::cout << std::fixed << std::setprecision(1) << marker.dictionary << ' ' << marker.id
                << ": known after " << rows << " of " << picture.height << " rows, "
                << (picture.height - rows) * row_ms << " ms before the end of the read-out\n";
    }
    reported = detector->markers().size();
  };

  check(detector->begin(picture.width, picture.height));
  for (int row = 0; row < picture.height; row += rows_at_a_time) {
    const int count = std::min(rows_at_a_time, picture.height - row);
    check(detector->push_rows(frame.rows(row, count)));
    report(row + count);
  }
  check(detector->end());
  report(picture.height);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int rows_at_a_time = argc == 3 ? std::atoi(argv[2]) : 8;
    if (argc < 2 || argc > 3 || rows_at_a_time < 1) {
      throw std::runtime_error("usage: stream_rows PICTURE.pgm [ROWS_AT_A_TIME]");
    }
    stream(read_pgm(argv[1]), rows_at_a_time);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
