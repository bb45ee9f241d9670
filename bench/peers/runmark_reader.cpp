#include "bench/peers/runmark_reader.h"

#include <stdexcept>

#include "runmark/detector.h"

namespace runmark::bench {
namespace {

Detector make_detector(const Task& task) {
  Options options;
  options.inverted = task.inverted;
  options.max_width = task.largest.width;
  options.max_height = task.largest.height;
  auto detector = Detector::create(options, {task.dictionaries.begin(), task.dictionaries.end()});
  if (!detector) throw std::runtime_error(detector.error());
  return *std::move(detector);
}

class RunmarkReader : public Reader {
 public:
  explicit RunmarkReader(const Task& task) : detector_(make_detector(task)) {}

  std::vector<Observation> read(const cv::Mat& grey) override {
    const auto view =
        ImageView::grey(grey.data, grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step[0]));
    return observations_of(detector_.detect(view));
  }

 private:
  Detector detector_;
};

}  // namespace

std::unique_ptr<Reader> make_runmark_reader(const Task& task) {
  return std::make_unique<RunmarkReader>(task);
}

}  // namespace runmark::bench
