#include "image_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "errors.h"
#include "jpeg_end.h"
#include "library_messages.h"

namespace runmark::cli {
namespace {

constexpr std::streamoff largest_file = std::streamoff{1} << 30U;

std::vector<std::uint8_t> read_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? std::streamoff{file.tellg()} : -1;
  if (size > largest_file) throw InputError(path + ": larger than a gigabyte, too large for an image");
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw InputError(path + ": " + std::strerror(errno != 0 ? errno : EIO));
  return bytes;
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

cv::Mat to_grey_or_bgr(const cv::Mat& image, const std::string& where) {
  if (image.empty()) throw InputError(where + ": not an image that can be read, or a damaged one");
  switch (image.channels()) {
    case 1:
    case 3:
      return to_eight_bits(image, where);
    case 4:
      return over_white(to_eight_bits(image, where));
    default:
      throw InputError(where + ": images with " + std::to_string(image.channels()) +
                       " channels cannot be read");
  }
}

}  // namespace

cv::Mat decode_image(std::span<const std::uint8_t> bytes, const std::string& where) {
  if (bytes.empty()) throw InputError(where + ": the file is empty");
  const bool jpeg = bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
  // libjpeg would fill the missing part with grey and call it a picture.
  if (jpeg && JpegEnd().find(bytes) == 0)
    throw InputError(where + ": the picture breaks off (no end of JPEG data)");
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
  try {
    const QuietStderr quiet;
    return to_grey_or_bgr(cv::imdecode(buffer, cv::IMREAD_UNCHANGED), where);
  } catch (const cv::Exception& error) {
    throw InputError(where + ": cannot be decoded: " + error.err);
  }
}

cv::Mat read_image(const std::string& path) { return decode_image(read_file(path), path); }

std::optional<Frame> ImageSource::next() {
  if (given_) return {};
  given_ = true;
  return Frame{path_, 0, read_image(path_), true};
}

}  // namespace runmark::cli
