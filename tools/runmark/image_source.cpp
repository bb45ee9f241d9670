#include "image_source.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "errors.h"
#include "jpeg_end.h"
#include "library_messages.h"

namespace runmark::cli {
namespace {

std::vector<std::uint8_t> read_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::vector<char> bytes;
  if (file) bytes.assign(std::istreambuf_iterator<char>(file), {});
  if (!file || file.bad()) throw InputError(path + ": " + std::strerror(errno != 0 ? errno : EIO));
  return {bytes.begin(), bytes.end()};
}

cv::Mat to_eight_bits(const cv::Mat& image, const std::string& where) {
  cv::Mat result;
  switch (image.depth()) {
    case CV_8U:
      return image;
    // OpenCV's own reader takes the upper byte too, so 16-bit files look the same everywhere.
    case CV_16U:
      image.convertTo(result, CV_8U, 1.0 / 256, -0.499);
      return result;
    default:
      throw InputError(where + ": only 8 and 16-bit samples can be read");
  }
}

/// Lays BGRA over white: markers cut out of their page keep the light margin they need.
cv::Mat over_white(const cv::Mat& image) {
  cv::Mat result(image.size(), CV_8UC3);
  for (int y = 0; y < image.rows; ++y) {
    const auto* from = image.ptr<cv::Vec4b>(y);
    auto* to = result.ptr<cv::Vec3b>(y);
    for (int x = 0; x < image.cols; ++x) {
      const int alpha = from[x][3];
      for (int c = 0; c < 3; ++c) {
        to[x][c] = static_cast<std::uint8_t>((from[x][c] * alpha + 255 * (255 - alpha) + 127) / 255);
      }
    }
  }
  return result;
}

}  // namespace

cv::Mat decode_image(std::span<const std::uint8_t> bytes, const std::string& where) {
  if (bytes.empty()) throw InputError(where + ": the file is empty");
  const bool jpeg = bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
  // libjpeg would fill the missing part with grey and call it a picture.
  if (jpeg && JpegEnd().find(bytes) == 0)
    throw InputError(where + ": the picture breaks off (no end of JPEG data)");
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
  cv::Mat image;
  try {
    const QuietStderr quiet;
    image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw InputError(where + ": cannot be decoded: " + error.err);
  }
  if (image.empty()) throw InputError(where + ": not an image that can be read, or a damaged one");
  image = to_eight_bits(image, where);
  switch (image.channels()) {
    case 1:
    case 3:
      return image;
    case 4:
      return over_white(image);
    default:
      throw InputError(where + ": images with " + std::to_string(image.channels()) +
                       " channels cannot be read");
  }
}

cv::Mat read_image(const std::string& path) { return decode_image(read_file(path), path); }

std::optional<Frame> ImageSource::next() {
  if (given_) return {};
  given_ = true;
  return Frame{path_, 0, read_image(path_), true};
}

}  // namespace runmark::cli
