#include "bench/speed/workers.h"

#include <cstring>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "bench/peers/reader.h"
#include "runmark/detector.h"

namespace runmark::bench {
namespace {

// The usual first step of OpenCV's detectors: a window of 23 pixels, 7 below the local mean.
cv::Mat binary(const cv::Mat& grey) {
  cv::Mat result;
  cv::adaptiveThreshold(grey, result, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, 23, 7);
  return result;
}

/// runmark again, rows handed over one by one.
Worker streamed(const TimedFrame& frame) {
  Options options;
  options.inverted = frame.inverted;
  options.max_width = frame.grey.cols;
  options.max_height = frame.grey.rows;
  auto made = Detector::create(options, frame.dictionaries);
  if (!made) throw std::runtime_error(made.error());
  auto detector = std::make_shared<Detector>(*std::move(made));
  return {"runmark-streamed", 1, [detector, &frame] {
            const auto stride = static_cast<std::ptrdiff_t>(frame.grey.step[0]);
            static_cast<void>(detector->begin(frame.grey.cols, frame.grey.rows));
            for (int y = 0; y < frame.grey.rows; ++y) {
              static_cast<void>(
                  detector->push_rows(ImageView::grey(frame.grey.ptr(y), frame.grey.cols, 1, stride)));
            }
            static_cast<void>(detector->end());
          }};
}

}  // namespace

Worker reader_for(const char* name, const TimedFrame& frame) {
  const Task task{frame.dictionaries, frame.inverted, frame.grey.size()};
  std::shared_ptr<Reader> made = find_contender(name)->make(task);
  return {name, 1, [made, &frame] { static_cast<void>(made->read(frame.grey)); }};
}

std::vector<Worker> workers_for(const TimedFrame& frame) {
  std::vector<Worker> workers;
  for (const char* name : {"runmark", "opencv-subpix", "apriltag-1", "apriltag-2"}) {
    workers.push_back(reader_for(name, frame));
  }
  workers.push_back(streamed(frame));
  auto to = std::make_shared<cv::Mat>(frame.grey.size(), CV_8UC1, cv::Scalar(0));
  const cv::Mat grey = frame.grey.clone();  // one block of memory, whatever the frame is
  const std::size_t bytes = grey.total();
  workers.push_back({"copy", 8, [to, grey, bytes] { std::memcpy(to->data, grey.data, bytes); }});
  workers.push_back({"threshold", 1, [to, grey] { cv::threshold(grey, *to, 128, 255, cv::THRESH_BINARY); }});
  workers.push_back({"adaptiveThreshold", 1, [grey] { static_cast<void>(binary(grey)); }});
  const cv::Mat mask = binary(grey);
  workers.push_back({"connectedComponents", 1, [mask] {
                       cv::Mat labels;
                       cv::connectedComponents(mask, labels);
                     }});
  workers.push_back({"findContours", 1, [mask] {
                       std::vector<std::vector<cv::Point>> contours;
                       cv::findContours(mask, contours, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
                     }});
  return workers;
}

}  // namespace runmark::bench
