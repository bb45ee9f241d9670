// The markers of a video as a table, with OpenCV reading the frames: video_to_csv VIDEO DICTIONARY >
// markers.csv
#include <exception>
#include <iostream>
#include <opencv2/videoio.hpp>
#include <optional>
#include <stdexcept>

#include "runmark/detector.h"

namespace {

void convert(const std::string& path, const runmark::Dictionary& dictionary) {
  cv::VideoCapture video(path);
  if (!video.isOpened()) throw std::runtime_error(path + ": cannot be opened");
  std::optional<runmark::Detector> detector;
  std::cout << "frame,dictionary,id,x0,y0,x1,y1,x2,y2,x3,y3\n";
  cv::Mat frame;
  for (int number = 0; video.read(frame); ++number) {
    if (!detector) {  // all frames of a video have one size, so one detector serves them all
      auto made =
          runmark::Detector::create({.max_width = frame.cols, .max_height = frame.rows}, {dictionary});
      if (!made) throw std::runtime_error(made.error());
      detector.emplace(*std::move(made));
    }
    // The detector reads the frame where OpenCV keeps it.
    const auto view = runmark::ImageView::bgr(frame.data, frame.cols, frame.rows,
                                              static_cast<std::ptrdiff_t>(frame.step[0]));
    for (const runmark::Marker& marker : detector->detect(view)) {
      std::cout << number << ',' << marker.dictionary << ',' << marker.id;
      for (const runmark::Point& corner : marker.corners) std::cout << ',' << corner.x << ',' << corner.y;
      std::cout << '\n';
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::runtime_error("usage: video_to_csv VIDEO DICTIONARY");
    const auto dictionary = runmark::load_dictionary(argv[2]);
    if (!dictionary) throw std::runtime_error(dictionary.error());
    convert(argv[1], *dictionary);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
