#include "video_source.h"

#include <cmath>

#include "errors.h"
#include "interrupt.h"

namespace runmark::cli {
namespace {

std::optional<double> stated_rate(const cv::VideoCapture& capture) {
  const double rate = capture.get(cv::CAP_PROP_FPS);
  if (std::isfinite(rate) && rate > 0 && rate <= 1000) return rate;
  return {};
}

}  // namespace

VideoSource::VideoSource(std::string path) : path_(std::move(path)) {
  try {
    capture_.open(path_, cv::CAP_FFMPEG);
  } catch (const cv::Exception&) {  // told below
  }
  if (!capture_.isOpened()) throw InputError(path_ + ": not a video that can be read, or a damaged one");
  capture_.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);  // pixels as stored, as with images
}

std::optional<std::int64_t> VideoSource::frame_count() const {
  const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  if (!std::isfinite(count) || count < 1 || count > 1e9) return {};
  return std::llround(count);
}

bool VideoSource::complete_after(std::int64_t frames) const {
  // Some containers only estimate the count from the running time: allow for that.
  const auto stated = frame_count();
  return stated && *stated - frames <= 2 + *stated / 50;
}

std::optional<double> VideoSource::frame_rate() const { return stated_rate(capture_); }

std::optional<Frame> VideoSource::next() {
  Frame frame{path_, index_, {}, false};
  if (capture_.read(frame.pixels)) {
    ++index_;
    return frame;
  }
  if (index_ == 0) throw InputError(path_ + ": no frame of this video can be decoded");
  if (const auto stated = frame_count(); stated && !complete_after(index_)) {
    throw InputError(path_ + ": the video breaks off after " + std::to_string(index_) + " of " +
                     std::to_string(*stated) + " frames");
  }
  return {};
}

CameraSource::CameraSource(std::string name) : name_(std::move(name)) {
  try {
    if (name_.starts_with("camera:")) {
      capture_.open(std::stoi(name_.substr(7)), cv::CAP_V4L2);
    } else {
      capture_.open(name_, cv::CAP_V4L2);
    }
  } catch (const std::exception&) {  // told below
  }
  if (!capture_.isOpened()) throw InputError(name_ + ": no such camera, or it is in use");
}

std::optional<double> CameraSource::frame_rate() const { return stated_rate(capture_); }

std::optional<Frame> CameraSource::next() {
  Frame frame{name_, index_, {}, false};
  if (capture_.read(frame.pixels)) {
    ++index_;
    return frame;
  }
  if (interrupted()) return {};  // the signal may have cut the wait for the frame short
  throw InputError(name_ + ": the camera gave no frame after frame " + std::to_string(index_));
}

}  // namespace runmark::cli
