// Where the markers of one picture stand: pose PICTURE.pgm CAMERA.yml SIZE. The camera file is OpenCV's or
// ROS's; SIZE is the side of the markers, and distances come in its unit.
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "pgm.h"
#include "runmark/camera_file.h"
#include "runmark/detector.h"
#include "runmark/pose.h"

namespace {

void print_poses(const Picture& picture, const runmark::Camera& camera, double size) {
  auto dictionary = runmark::builtin_dictionary("tag36h11");
  if (!dictionary) throw std::runtime_error(dictionary.error());
  auto detector = runmark::Detector::create({.max_width = picture.width, .max_height = picture.height},
                                            {*std::move(dictionary)});
  if (!detector) throw std::runtime_error(detector.error());
  const auto view =
      runmark::ImageView::grey(picture.grey.data(), picture.width, picture.height, picture.width);
  for (const runmark::Marker& marker : detector->detect(view)) {
    // How sure the corners are is read from the picture; the pose's covariance follows from it.
    const auto found = runmark::pose(marker, size, camera, runmark::corner_covariance(marker, view));
    if (!found) continue;  // no square before this camera looks like that
    const runmark::PoseSolution& best = found->best;
    const auto [x, y, z] = best.pose.translation;
    std::cout << marker.dictionary << ' ' << marker.id << ": at " << x << ' ' << y << ' ' << z
              << ", distance +- " << std::sqrt(best.covariance[14]) << ", ambiguity " << found->ambiguity
              << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::runtime_error("usage: pose PICTURE.pgm CAMERA.yml SIZE");
    const auto camera = runmark::read_camera(argv[2]);
    if (!camera) throw std::runtime_error(camera.error());
    print_poses(read_pgm(argv[1]), *camera, std::atof(argv[3]));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
