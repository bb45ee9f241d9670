#include "bench/peers/apriltag_reader.h"

#include <algorithm>
#include <list>

#include "bench/peers/apriltag_family.h"

namespace runmark::bench {
namespace {

struct DestroyDetector {
  void operator()(apriltag_detector_t* detector) const { apriltag_detector_destroy(detector); }
};
struct DestroyDetections {
  void operator()(zarray_t* detections) const { apriltag_detections_destroy(detections); }
};

// AprilTag lists bottom-left first and goes round counter-clockwise, with pixel centres at .5.
Corners our_corners(const apriltag_detection_t& detection) {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {detection.p[3 - i][0] - 0.5, detection.p[3 - i][1] - 0.5};
  }
  return corners;
}

// AprilTag's own 2, but no more than OpenCV would correct in this dictionary (0.6 of what its distance
// allows): otherwise 4x4 dictionaries drown in false alarms.
int bits_to_correct(const Dictionary& dictionary) {
  return std::clamp((dictionary.distance - 1) / 2 * 6 / 10, 0, 2);
}

class AprilTagReader : public Reader {
 public:
  AprilTagReader(const Task& task, float decimate)
      : detector_(apriltag_detector_create()), inverted_(task.inverted) {
    detector_->nthreads = 1;
    detector_->quad_decimate = decimate;
    for (const Dictionary& ours : task.dictionaries) {
      auto family = AprilTagFamily::make(ours);
      if (!family) continue;
      families_.push_back(std::move(*family));
      apriltag_detector_add_family_bits(detector_.get(), families_.back().family(), bits_to_correct(ours));
    }
  }

  std::vector<Observation> read(const cv::Mat& grey) override {
    if (inverted_) cv::bitwise_not(grey, negative_);
    const cv::Mat& image = inverted_ ? negative_ : grey;
    // The detector only reads the pixels.
    image_u8_t view{image.cols, image.rows, static_cast<int>(image.step),
                    const_cast<std::uint8_t*>(image.data)};
    const std::unique_ptr<zarray_t, DestroyDetections> detections(
        apriltag_detector_detect(detector_.get(), &view));
    std::vector<Observation> found;
    for (int i = 0; i < zarray_size(detections.get()); ++i) {
      apriltag_detection_t* detection = nullptr;
      zarray_get(detections.get(), i, static_cast<void*>(&detection));
      found.push_back({detection->id, our_corners(*detection)});
    }
    return found;
  }

 private:
  std::list<AprilTagFamily> families_;  // the detector points at them
  std::unique_ptr<apriltag_detector_t, DestroyDetector> detector_;
  bool inverted_;
  cv::Mat negative_;
};

}  // namespace

std::unique_ptr<Reader> make_apriltag_reader(const Task& task, float decimate) {
  return std::make_unique<AprilTagReader>(task, decimate);
}

}  // namespace runmark::bench
