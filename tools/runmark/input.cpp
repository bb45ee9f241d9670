#include "input.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

#include "errors.h"

namespace runmark::cli {
namespace {

namespace fs = std::filesystem;

template <std::size_t N>
bool has_extension(const std::string& path, const std::array<std::string_view, N>& extensions) {
  std::string extension = fs::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(extensions, extension) != extensions.end();
}

/// Files our own stream reader takes rather than OpenCV's.
bool is_stream_name(const std::string& path) { return has_extension<3>(path, {".y4m", ".mjpeg", ".mjpg"}); }

bool is_camera(const std::string& argument) {
  return argument.starts_with("camera:") || argument.starts_with("/dev/video");
}

InputKind kind_by_content(const std::string& path) {
  std::array<char, 10> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  if (std::string_view(start.data(), start.size()) == "YUV4MPEG2 ") return InputKind::stream;
  return cv::haveImageReader(path) ? InputKind::image : InputKind::video;
}

InputKind kind_of_file(const std::string& path) {
  if (is_stream_name(path)) return InputKind::stream;
  if (is_image_name(path)) return InputKind::image;
  if (is_video_name(path)) return InputKind::video;
  return kind_by_content(path);
}

void add_folder(const std::string& folder, std::vector<Input>& inputs) {
  std::error_code error;
  std::vector<std::string> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string path = it->path().string();
    const bool wanted = is_image_name(path) || is_video_name(path) || is_stream_name(path);
    // A file whose type cannot be asked for (a dangling link) is kept: its reader says what is wrong.
    std::error_code ignored;
    const fs::file_type type = it->status(ignored).type();
    if (wanted && (type == fs::file_type::regular || type == fs::file_type::not_found)) files.push_back(path);
  }
  if (error) throw UserError(folder + ": " + error.message());
  if (files.empty()) throw UserError(folder + ": no images or videos in this folder");
  std::ranges::sort(files);
  for (const std::string& path : files) inputs.push_back({kind_of_file(path), path});
}

void check_camera(const std::string& argument) {
  if (!argument.starts_with("camera:")) return;
  const std::string_view number = std::string_view(argument).substr(7);
  int index = -1;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc{} || stop != number.data() + number.size() || index < 0) {
    throw UserError(argument + ": a camera is named by its number, as in camera:0");
  }
}

}  // namespace

bool is_image_name(const std::string& path) {
  return has_extension<12>(path, {".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".pbm", ".pnm", ".bmp", ".tif",
                                  ".tiff", ".webp", ".jp2"});
}

bool is_video_name(const std::string& path) {
  return has_extension<10>(path,
                           {".mp4", ".m4v", ".mov", ".avi", ".mkv", ".webm", ".mpg", ".mpeg", ".ts", ".ogv"});
}

std::vector<Input> find_inputs(const std::vector<std::string>& arguments) {
  std::vector<Input> inputs;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (argument == "-") {
      inputs.push_back({InputKind::stream, argument});
    } else if (is_camera(argument)) {
      check_camera(argument);
      inputs.push_back({InputKind::camera, argument});
    } else if (fs::is_directory(argument, error)) {
      add_folder(argument, inputs);
    } else if (::access(argument.c_str(), R_OK) != 0) {
      throw UserError(argument + ": " + std::strerror(errno));
    } else if (!fs::is_regular_file(argument, error)) {
      inputs.push_back({InputKind::stream, argument});  // a named pipe: can be read only once, and forwards
    } else {
      inputs.push_back({kind_of_file(argument), argument});
    }
  }
  if (std::ranges::count(inputs, "-", &Input::name) > 1) throw UserError("'-' can be read only once");
  return inputs;
}

}  // namespace runmark::cli
