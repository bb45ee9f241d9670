#include "byte_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "errors.h"
#include "interrupt.h"

namespace runmark::cli {

ByteStream::ByteStream(std::string name) : where_(std::move(name)) {
  if (where_ == "-") {
    where_ = "standard input";
    file_ = STDIN_FILENO;
    if (isatty(file_) != 0)
      throw InputError("standard input is a terminal; pipe a Y4M or MJPEG stream into it");
    return;
  }
  file_ = ::open(where_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) throw InputError(where_ + ": " + std::strerror(errno));
}

ByteStream::~ByteStream() {
  if (file_ != STDIN_FILENO) ::close(file_);
}

std::span<const std::uint8_t> ByteStream::peek(std::size_t count) {
  if (begin_ > 0 && begin_ + count > buffer_.size()) {
    std::copy(buffer_.data() + begin_, buffer_.data() + end_, buffer_.data());
    end_ -= begin_;
    begin_ = 0;
  }
  constexpr std::size_t least = std::size_t{1} << 16U;
  while (end_ - begin_ < count) {
    // Grows with what has come, not with what a header promises.
    if (end_ == buffer_.size()) buffer_.resize(std::max(least, 2 * buffer_.size()));
    if (!wait_for_input(file_)) break;
    const ssize_t got = ::read(file_, buffer_.data() + end_, buffer_.size() - end_);
    if (got > 0) {
      end_ += static_cast<std::size_t>(got);
    } else if (got == 0) {
      break;
    } else if (errno != EINTR) {
      throw InputError(where_ + ": " + std::strerror(errno));
    }
  }
  return {buffer_.data() + begin_, end_ - begin_};
}

}  // namespace runmark::cli
