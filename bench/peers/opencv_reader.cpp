#include "bench/peers/opencv_reader.h"

#include <array>
#include <opencv2/aruco.hpp>
#include <optional>
#include <utility>

namespace runmark::bench {
namespace {

struct Predefined {
  std::string_view name;
  int opencv;
  bool turned;  // OpenCV 4 draws AprilTag families by 180 degrees away from the official tag images
};

constexpr std::array predefined{
    Predefined{"DICT_4X4_50", cv::aruco::DICT_4X4_50, false},
    Predefined{"DICT_4X4_100", cv::aruco::DICT_4X4_100, false},
    Predefined{"DICT_4X4_250", cv::aruco::DICT_4X4_250, false},
    Predefined{"DICT_4X4_1000", cv::aruco::DICT_4X4_1000, false},
    Predefined{"DICT_5X5_50", cv::aruco::DICT_5X5_50, false},
    Predefined{"DICT_5X5_100", cv::aruco::DICT_5X5_100, false},
    Predefined{"DICT_5X5_250", cv::aruco::DICT_5X5_250, false},
    Predefined{"DICT_5X5_1000", cv::aruco::DICT_5X5_1000, false},
    Predefined{"DICT_6X6_50", cv::aruco::DICT_6X6_50, false},
    Predefined{"DICT_6X6_100", cv::aruco::DICT_6X6_100, false},
    Predefined{"DICT_6X6_250", cv::aruco::DICT_6X6_250, false},
    Predefined{"DICT_6X6_1000", cv::aruco::DICT_6X6_1000, false},
    Predefined{"DICT_7X7_50", cv::aruco::DICT_7X7_50, false},
    Predefined{"DICT_7X7_100", cv::aruco::DICT_7X7_100, false},
    Predefined{"DICT_7X7_250", cv::aruco::DICT_7X7_250, false},
    Predefined{"DICT_7X7_1000", cv::aruco::DICT_7X7_1000, false},
    Predefined{"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL, false},
    Predefined{"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5, true},
    Predefined{"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9, true},
    Predefined{"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10, true},
    Predefined{"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11, true},
    Predefined{"tag16h5", cv::aruco::DICT_APRILTAG_16h5, true},
    Predefined{"tag25h9", cv::aruco::DICT_APRILTAG_25h9, true},
    Predefined{"tag36h10", cv::aruco::DICT_APRILTAG_36h10, true},
    Predefined{"tag36h11", cv::aruco::DICT_APRILTAG_36h11, true},
};

struct Codes {
  cv::Ptr<cv::aruco::Dictionary> dictionary;
  bool turned = false;
};

Codes from_cells(const Dictionary& ours) {
  const int side = ours.width - 2;
  auto codes = cv::makePtr<cv::aruco::Dictionary>(cv::Mat(), side, (ours.distance - 1) / 2);
  for (const std::uint64_t code : ours.codes) {
    cv::Mat bits(side, side, CV_8UC1, cv::Scalar(0));
    for (std::size_t i = 0; i < ours.cells.size(); ++i) {
      const Cell cell = ours.cells[i];
      bits.at<std::uint8_t>(cell.y - 1, cell.x - 1) =
          static_cast<std::uint8_t>(code >> (ours.cells.size() - 1 - i) & 1U);
    }
    codes->bytesList.push_back(cv::aruco::Dictionary::getByteListFromBits(bits));
  }
  return {codes, false};
}

std::optional<Codes> codes_of(const Dictionary& ours) {
  if (ours.border != Border::black) return std::nullopt;
  for (const Predefined& p : predefined) {
    if (p.name == ours.name) return Codes{cv::aruco::getPredefinedDictionary(p.opencv), p.turned};
  }
  return from_cells(ours);
}

class OpenCvReader : public Reader {
 public:
  OpenCvReader(const Task& task, Refinement refinement)
      : parameters_(cv::aruco::DetectorParameters::create()) {
    cv::setNumThreads(1);
    parameters_->detectInvertedMarker = task.inverted;
    if (refinement == Refinement::sub_pixel) {
      parameters_->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
    }
    for (const Dictionary& ours : task.dictionaries) {
      if (auto codes = codes_of(ours)) codes_.push_back(*codes);
    }
  }

  std::vector<Observation> read(const cv::Mat& grey) override {
    std::vector<Observation> found;
    for (const Codes& codes : codes_) {
      cv::aruco::detectMarkers(grey, codes.dictionary, corners_, ids_, parameters_);
      for (std::size_t i = 0; i < ids_.size(); ++i) {
        Observation marker{ids_[i], {}};
        for (std::size_t j = 0; j < 4; ++j) {
          const cv::Point2f p = corners_[i][codes.turned ? (j + 2) % 4 : j];
          marker.corners[j] = {static_cast<double>(p.x), static_cast<double>(p.y)};
        }
        found.push_back(marker);
      }
    }
    return found;
  }

 private:
  cv::Ptr<cv::aruco::DetectorParameters> parameters_;
  std::vector<Codes> codes_;
  std::vector<std::vector<cv::Point2f>> corners_;
  std::vector<int> ids_;
};

}  // namespace

std::unique_ptr<Reader> make_opencv_reader(const Task& task, Refinement refinement) {
  return std::make_unique<OpenCvReader>(task, refinement);
}

}  // namespace runmark::bench
