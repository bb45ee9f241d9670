// Any text as a camera file (YAML of OpenCV or ROS) or, after a first byte that is odd, as a board file
// (JSON): refused in one line, or taken; and what was taken can be written down and read again.

#include <cmath>
#include <string_view>

#include "expect.h"
#include "runmark/board_file.h"
#include "runmark/camera_file.h"

namespace runmark::fuzz {
namespace {

void expect_one_line(const std::string& error) {
  expect(!error.empty() && error.find('\n') == std::string::npos, "an error is one line");
}

void read_as_camera(std::string_view text) {
  const auto camera = parse_camera(text);
  if (!camera) return expect_one_line(camera.error());
  expect(camera->is_valid(), "a camera that was read makes sense");
  for (const CameraFormat format : {CameraFormat::opencv, CameraFormat::ros}) {
    const auto again = parse_camera(camera_text(*camera, format));
    expect(static_cast<bool>(again), "what is written can be read");
    expect(again->fx == camera->fx && again->fy == camera->fy && again->cx == camera->cx &&
               again->cy == camera->cy,
           "the same camera matrix");
    expect(again->distortion == camera->distortion, "the same distortion");
    expect(again->width == camera->width && again->height == camera->height, "the same size");
  }
}

void read_as_board(std::string_view text) {
  const auto board = parse_board(text);
  if (!board) expect_one_line(board.error());
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0) runmark::fuzz::read_as_camera(text);
  if (data[0] % 2 == 1) runmark::fuzz::read_as_board(text);
  return 0;
}
