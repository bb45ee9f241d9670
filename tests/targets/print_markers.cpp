// print_markers PICTURE.pgm...: what every pipeline finds in the pictures, each number to its last bit, and
// first the vectors the cores run on.

#include <hwy/highway.h>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <utility>

#include "pgm.h"
#include "runmark/detector.h"

namespace {

void print_frame(const char* name, runmark::Detector& detector, const runmark::ImageView& view) {
  const runmark::Detection found = detector.detect(view);
  const runmark::FrameStats& stats = detector.stats();
  std::printf("%s: %llu crack runs, %llu contours, %llu quads, %zu markers\n", name,
              static_cast<unsigned long long>(stats.crack_runs),
              static_cast<unsigned long long>(stats.closed_chains),
              static_cast<unsigned long long>(stats.quads), found.markers.size());
  for (const runmark::Marker& marker : found) {
    std::printf(" %d %d %d %a", marker.id, marker.hamming, marker.row, static_cast<double>(marker.margin));
    for (const runmark::Point& corner : marker.corners) std::printf(" %a %a", corner.x, corner.y);
    std::printf("\n");
  }
}

void print_picture(const char* path) {
  using runmark::Pipeline;
  const Picture picture = read_pgm(path);
  for (const Pipeline pipeline : {Pipeline::paper, Pipeline::hardware, Pipeline::standard}) {
    runmark::Options options;
    options.pipeline = pipeline;
    options.max_width = picture.width;
    options.max_height = picture.height;
    auto dictionary = runmark::builtin_dictionary("tag36h11");
    if (!dictionary) throw std::runtime_error(dictionary.error());
    auto detector = runmark::Detector::create(options, {*std::move(dictionary)});
    if (!detector) throw std::runtime_error(detector.error());
    print_frame(path, *detector,
                runmark::ImageView::grey(picture.grey.data(), picture.width, picture.height, picture.width));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    std::fprintf(stderr, "compiled in: ");
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
      std::fprintf(stderr, "%s ", hwy::TargetName(left & -left));
    }
    std::fprintf(stderr, "\n");
    for (int i = 1; i < argc; ++i) print_picture(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "print_markers: %s\n", error.what());
    return 2;
  }
  return 0;
}
