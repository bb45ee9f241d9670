// Where a board stands and what is seen of it: board PICTURE.pgm CAMERA.yml BOARD, with BOARD such as
// charuco:DICT_5X5_100:6x8:28:20 or a .json file.
#include <exception>
#include <iostream>
#include <set>
#include <stdexcept>

#include "pgm.h"
#include "runmark/board_file.h"
#include "runmark/board_view.h"
#include "runmark/camera_file.h"
#include "runmark/detector.h"

namespace {

runmark::Detector make_detector(const runmark::Board& board, const Picture& picture) {
  std::set<std::string> names;
  for (const runmark::BoardMarker& marker : board.markers) names.insert(marker.dictionary);
  std::vector<runmark::Dictionary> dictionaries;
  for (const std::string& name : names) {
    auto dictionary = runmark::load_dictionary(name);
    if (!dictionary) throw std::runtime_error(dictionary.error());
    dictionaries.push_back(*std::move(dictionary));
  }
  auto detector = runmark::Detector::create({.max_width = picture.width, .max_height = picture.height},
                                            std::move(dictionaries));
  if (!detector) throw std::runtime_error(detector.error());
  return *std::move(detector);
}

void print_board(const Picture& picture, const runmark::Camera& camera, const runmark::Board& board) {
  runmark::Detector detector = make_detector(board, picture);
  const auto frame =
      runmark::ImageView::grey(picture.grey.data(), picture.width, picture.height, picture.width);
  const auto found = detector.detect(frame).markers;
  const std::string advice = runmark::layout_advice(board, found);
  if (!advice.empty()) throw std::runtime_error(advice);

  const runmark::BoardView view = runmark::view_board(board, found, frame);
  std::cout << view.markers.size() << " markers, " << view.corners.size() << " chessboard corners\n";
  const auto estimate = runmark::pose(board, view, camera);
  if (!estimate) throw std::runtime_error(estimate.error());
  const auto [x, y, z] = estimate->best.pose.translation;
  std::cout << "its first corner is at " << x << ' ' << y << ' ' << z << ", corners fit to "
            << estimate->best.error << " px\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::runtime_error("usage: board PICTURE.pgm CAMERA.yml BOARD");
    const auto camera = runmark::read_camera(argv[2]);
    if (!camera) throw std::runtime_error(camera.error());
    const auto board = runmark::load_board(argv[3]);
    if (!board) throw std::runtime_error(board.error());
    print_board(read_pgm(argv[1]), *camera, *board);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
