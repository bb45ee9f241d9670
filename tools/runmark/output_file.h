#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace runmark::cli {

/// Where a command's results go: standard output or a file. Every write that fails is an error; a
/// reader that has gone away (`| head`) ends the program quietly with status 0.
class OutputFile {
 public:
  /// An empty path is standard output. Throws UserError.
  explicit OutputFile(std::string path = {});
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes whole lines; a terminal or pipe gets them at once.
  void write(std::string_view lines);

  /// Everything is on its way to the disk, or a UserError is thrown.
  void close();

  [[nodiscard]] bool is_terminal() const { return is_terminal_; }

 private:
  void flush();
  [[noreturn]] void fail() const;

  std::string where_;
  std::FILE* file_ = nullptr;
  bool is_terminal_ = false;
  bool flush_each_ = false;
};

/// Writes a file as a whole. Throws UserError.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace runmark::cli
