#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace runmark::cli {

/// Where a command's results go: standard output or a file. Every write that fails is an error; a
/// reader that has gone away (`| head`) ends the program quietly with status 0. Lines go out at once and
/// whole: nothing is held back that a sudden end could lose, and a full disk leaves no piece of a line.
class OutputFile {
 public:
  /// An empty path is standard output. Throws UserError.
  explicit OutputFile(std::string path = {});
  /// Goes on with an existing file behind its first `kept` bytes, the rest of which is cut off, or makes it.
  /// No other process may do so at the same time. Throws UserError.
  OutputFile(std::string path, std::uint64_t kept);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes whole lines.
  void write(std::string_view lines);

  /// Some disks tell only now that something could not be written; a UserError is thrown then.
  void close();

  [[nodiscard]] bool is_terminal() const;

 private:
  void open(int flags);
  [[noreturn]] void fail() const;

  std::string where_;
  int file_ = -1;
};

/// Writes a file as a whole. Throws UserError.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace runmark::cli
