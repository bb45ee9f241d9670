#include "y4m_source.h"

#include <algorithm>
#include <charconv>

namespace runmark::cli {
namespace {

constexpr std::size_t longest_line = 4096;
constexpr int largest_side = 65535;

int positive_number(std::string_view text) {
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size() && value > 0 ? value : 0;
}

}  // namespace

Y4mSource::Y4mSource(std::string name, std::unique_ptr<ByteStream> bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
  const std::string header = read_line();
  std::string_view rest = header;
  while (!rest.empty()) {
    const std::size_t space = std::min(rest.find(' '), rest.size());
    read_parameter(rest.substr(0, space));
    rest.remove_prefix(std::min(space + 1, rest.size()));
  }
  if (width_ == 0 || height_ == 0 || width_ > largest_side || height_ > largest_side) {
    throw error("its header must state a width and a height of 1 to 65535");
  }
  set_colour_space(colour_space_);
}

void Y4mSource::read_parameter(std::string_view parameter) {
  if (parameter.empty()) return;
  const std::string_view value = parameter.substr(1);
  switch (parameter[0]) {
    case 'W':
      width_ = positive_number(value);
      break;
    case 'H':
      height_ = positive_number(value);
      break;
    case 'C':
      colour_space_ = value;
      break;
    case 'F': {
      const std::size_t colon = std::min(value.find(':'), value.size());
      const int frames = positive_number(value.substr(0, colon));
      const int seconds = positive_number(value.substr(std::min(colon + 1, value.size())));
      if (frames > 0 && seconds > 0) frame_rate_ = static_cast<double>(frames) / seconds;
      break;
    }
    default:
      break;  // interlacing, aspect ratio, comments: nothing a detector needs
  }
}

void Y4mSource::set_colour_space(std::string_view name) {
  const auto width = static_cast<std::size_t>(width_);
  const auto height = static_cast<std::size_t>(height_);
  if (name == "420" || name == "420jpeg" || name == "420mpeg2" || name == "420paldv") {
    chroma_bytes_ = 2 * ((width + 1) / 2) * ((height + 1) / 2);
  } else if (name == "411") {
    chroma_bytes_ = 2 * ((width + 3) / 4) * height;
  } else if (name == "422") {
    chroma_bytes_ = 2 * ((width + 1) / 2) * height;
  } else if (name == "444") {
    chroma_bytes_ = 2 * width * height;
  } else if (name == "444alpha") {
    chroma_bytes_ = 3 * width * height;
  } else if (name == "mono") {
    chroma_bytes_ = 0;
  } else {
    throw error("colour space " + std::string(name) +
                " cannot be read; 8-bit 420, 411, 422, 444 and mono can");
  }
}

InputError Y4mSource::error(const std::string& what) const {
  return InputError(bytes_->where() + ": Y4M stream: " + what);
}

std::string Y4mSource::read_line() {
  for (std::size_t searched = 0;;) {
    const auto data = bytes_->peek(searched + 1);
    const auto feed = std::find(data.begin() + static_cast<std::ptrdiff_t>(searched), data.end(), '\n');
    if (feed != data.end()) {
      std::string line(data.begin(), feed);
      bytes_->skip(line.size() + 1);
      return line;
    }
    if (data.size() == searched || data.size() > longest_line) throw error("a header line does not end");
    searched = data.size();
  }
}

std::optional<Frame> Y4mSource::next() {
  if (bytes_->peek(1).empty()) {
    if (index_ == 0) throw error("no frames");
    return {};
  }
  const std::string number = std::to_string(index_);
  const std::string header = read_line();
  if (header != "FRAME" && !header.starts_with("FRAME "))
    throw error("no FRAME where frame " + number + " begins");
  const std::size_t luma = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  const auto data = bytes_->peek(luma + chroma_bytes_);
  if (data.size() < luma + chroma_bytes_) throw error("ends within frame " + number);
  Frame frame{name_, index_, cv::Mat(height_, width_, CV_8U), false};
  std::copy_n(data.data(), luma, frame.pixels.data);
  bytes_->skip(luma + chroma_bytes_);
  ++index_;
  return frame;
}

}  // namespace runmark::cli
