#include "image_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <initializer_list>
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

bool begins_with(std::span<const std::uint8_t> bytes, std::initializer_list<std::uint8_t> magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

void check_size(std::uint64_t pixels, std::uint64_t most_pixels, const std::string& where) {
  if (pixels > most_pixels)
    throw InputError(where + ": damaged: its header states more pixels than its data can hold");
}

/// libjpeg would fill what is missing with grey and call it a picture, however large a header says it is.
void check_jpeg(std::span<const std::uint8_t> bytes, const std::string& where) {
  // A block of 64 pixels takes a bit or more; eight times that leaves room for arithmetic coding.
  constexpr std::uint64_t most_pixels_a_byte = 4096;
  JpegEnd end;
  if (end.find(bytes) == 0) throw InputError(where + ": the picture breaks off (no end of JPEG data)");
  check_size(end.pixels(), most_pixels_a_byte * bytes.size(), where);
}

/// The header chunk's width and height. Source: PNG specification, 11.2.2.
void check_png(std::span<const std::uint8_t> bytes, const std::string& where) {
  constexpr std::uint64_t most_pixels_a_byte = 8 * 1032;  // one bit each, deflate at its best
  constexpr std::size_t size_at = 16;
  if (bytes.size() < size_at + 8) return;
  const auto number = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (const std::uint8_t byte : bytes.subspan(at, 4)) value = value << 8U | byte;
    return value;
  };
  check_size(number(size_at) * number(size_at + 4), most_pixels_a_byte * bytes.size(), where);
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
  // Memory is for what has come, not for what a header promises.
  if (begins_with(bytes, {0xFF, 0xD8})) check_jpeg(bytes, where);
  if (begins_with(bytes, {0x89, 'P', 'N', 'G'})) check_png(bytes, where);
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
