#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace runmark::cli {

/// A file or pipe read forwards only, with what was read ahead kept at hand.
class ByteStream {
 public:
  /// "-" is standard input. Throws InputError.
  explicit ByteStream(std::string name);
  ~ByteStream();
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// At least `count` bytes from here on, or all there are when the stream ends before; they stay
  /// valid until the next call. Throws InputError when reading fails.
  [[nodiscard]] std::span<const std::uint8_t> peek(std::size_t count);

  /// Goes on by `count` bytes, which must have been peeked.
  void skip(std::size_t count) { begin_ += count; }

  /// "standard input" or the path: for errors.
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  std::string where_;
  int file_ = -1;
  std::vector<std::uint8_t> buffer_;
  std::size_t begin_ = 0;  ///< the bytes at hand are [begin_, end_) of the buffer
  std::size_t end_ = 0;
};

}  // namespace runmark::cli
