#include "output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "errors.h"

namespace runmark::cli {

OutputFile::OutputFile(std::string path) : where_(std::move(path)) {
  std::signal(SIGPIPE, SIG_IGN);  // told apart by EPIPE
  file_ = where_.empty() ? stdout : std::fopen(where_.c_str(), "wb");
  if (where_.empty()) where_ = "standard output";
  if (file_ == nullptr) throw UserError(where_ + ": " + std::strerror(errno));
  is_terminal_ = isatty(fileno(file_)) != 0;
  struct stat status {};
  flush_each_ = fstat(fileno(file_), &status) != 0 || !S_ISREG(status.st_mode);
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

void OutputFile::write(std::string_view lines) {
  if (std::fwrite(lines.data(), 1, lines.size(), file_) != lines.size()) fail();
  if (flush_each_) flush();
}

void OutputFile::close() {
  flush();
  std::FILE* file = std::exchange(file_, nullptr);
  if (file != stdout && std::fclose(file) != 0) fail();
}

void OutputFile::flush() {
  while (std::fflush(file_) != 0) {
    if (errno != EINTR) fail();
    std::clearerr(file_);
  }
}

void OutputFile::fail() const {
  if (errno == EPIPE) throw ExitStatus{0};
  throw UserError(where_ + ": " + std::strerror(errno));
}

void write_file(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.close();
}

}  // namespace runmark::cli
