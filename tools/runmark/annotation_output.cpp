#include "annotation_output.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string_view>

#include "annotate.h"
#include "errors.h"
#include "output_file.h"

namespace runmark::cli {
namespace {

namespace fs = std::filesystem;

bool is_video_target(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  return extension == ".mp4" || extension == ".avi";
}

std::string stem_of(const Input& input) {
  if (input.name == "-") return "stdin";
  std::string stem = fs::path(input.name).stem().string();
  std::ranges::replace(stem, ':', '-');  // camera:0
  return stem;
}

/// H.264 plays everywhere; MPEG-4 and Motion JPEG where FFmpeg was built without an encoder for it.
std::vector<int> codecs_for(const std::string& path) {
  if (path.ends_with(".avi")) return {cv::VideoWriter::fourcc('M', 'J', 'P', 'G')};
  return {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')};
}

/// Video encoders want even sides.
cv::Mat with_even_sides(const cv::Mat& picture) {
  if (picture.cols % 2 == 0 && picture.rows % 2 == 0) return picture;
  cv::Mat result;
  cv::copyMakeBorder(picture, result, 0, picture.rows % 2, 0, picture.cols % 2, cv::BORDER_REPLICATE);
  return result;
}

}  // namespace

AnnotationOutput::AnnotationOutput(std::string path, const std::vector<Input>& inputs)
    : path_(std::move(path)), inputs_(inputs) {
  std::error_code error;
  const bool image = is_image_name(path_);
  const bool video = is_video_target(path_);
  is_folder_ = fs::is_directory(path_, error) || (!image && !video);
  if (is_folder_) {
    fs::create_directories(path_, error);
    if (error) throw UserError(path_ + ": cannot make this folder: " + error.message());
    return;
  }
  if (inputs_.size() != 1) throw UserError(path_ + ": several inputs need a folder to be annotated into");
  if (image && inputs_[0].moving())
    throw UserError(path_ + ": a video is annotated into an .mp4, an .avi or a folder");
  if (video && !inputs_[0].moving())
    throw UserError(path_ + ": an image is annotated into an image or a folder");
}

std::string AnnotationOutput::path_for(const Input& input) {
  if (!is_folder_) return path_;
  const std::string stem = stem_of(input);
  const std::string extension = input.moving() ? ".mp4" : ".png";
  std::string name = stem + extension;
  for (int n = 2; !used_names_.insert(name).second; ++n) {
    name = stem + '-';
    name += std::to_string(n) + extension;
  }
  return (fs::path(path_) / name).string();
}

void AnnotationOutput::check_not_an_input(const std::string& path) const {
  for (const Input& input : inputs_) {
    std::error_code error;
    if (input.name != "-" && fs::equivalent(path, input.name, error)) {
      throw UserError(path + ": the annotated picture would replace an input");
    }
  }
}

void AnnotationOutput::begin(const Input& input, double rate) {
  current_ = path_for(input);
  check_not_an_input(current_);
  rate_ = rate;
  video_frames_ = 0;
}

void AnnotationOutput::write(const Frame& frame, std::span<const Marker> markers,
                             std::span<const AxesPicture> axes) {
  cv::Mat picture = annotate(frame.pixels, markers);
  for (const AxesPicture& a : axes) draw_axes(picture, a);
  if (!frame.still) return write_video_frame(with_even_sides(picture));
  std::vector<std::uint8_t> bytes;
  try {
    cv::imencode(fs::path(current_).extension().string(), picture, bytes);
  } catch (const cv::Exception& error) {
    throw UserError(current_ + ": cannot be encoded: " + error.err);
  }
  write_file(current_, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void AnnotationOutput::write_video_frame(const cv::Mat& picture) {
  if (video_frames_ == 0) {
    video_size_ = picture.size();
    for (const int codec : codecs_for(current_)) {
      if (video_.open(current_, cv::CAP_FFMPEG, codec, rate_, video_size_)) break;
    }
    if (!video_.isOpened()) throw UserError(current_ + ": this video cannot be written");
  }
  if (picture.size() == video_size_) {
    video_.write(picture);
  } else {  // a stream may change its size, a video file cannot
    cv::Mat scaled;
    cv::resize(picture, scaled, video_size_, 0, 0, cv::INTER_AREA);
    video_.write(scaled);
  }
  ++video_frames_;
}

void AnnotationOutput::end() {
  if (!video_.isOpened()) return;
  video_.release();
  // OpenCV does not tell when the disk is full: count what arrived.
  const cv::VideoCapture written(current_, cv::CAP_FFMPEG);
  const auto frames =
      static_cast<std::int64_t>(written.isOpened() ? written.get(cv::CAP_PROP_FRAME_COUNT) : 0);
  if (frames < video_frames_) throw UserError(current_ + ": not all frames could be written");
}

}  // namespace runmark::cli
