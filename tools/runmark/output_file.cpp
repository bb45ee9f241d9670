#include "output_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "errors.h"

namespace runmark::cli {
namespace {

bool is_regular(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

/// Waits until a pipe that must not block takes more.
void wait_for_room(int file) {
  pollfd waiting{file, POLLOUT, 0};
  ::poll(&waiting, 1, -1);
}

/// How many bytes arrived; errno says why not all.
std::size_t write_all(int file, std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    if (written >= 0) {
      done += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN) {
      wait_for_room(file);
    } else if (errno != EINTR) {
      break;
    }
  }
  return done;
}

/// Takes back what arrived of lines that could not be written whole.
void take_back(int file, std::size_t bytes) {
  const int error = errno;
  const off_t end = ::lseek(file, 0, SEEK_CUR);
  const auto cut = end - static_cast<off_t>(bytes);
  if (bytes > 0 && is_regular(file) && ::ftruncate(file, cut) == 0) ::lseek(file, cut, SEEK_SET);
  errno = error;
}

}  // namespace

OutputFile::OutputFile(std::string path) : where_(std::move(path)) { open(O_TRUNC); }

OutputFile::OutputFile(std::string path, std::uint64_t kept) : where_(std::move(path)) {
  open(0);
  if (!is_regular(file_)) throw UserError(where_ + ": not a file that a run can go on with");
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) throw UserError(where_ + ": another run is writing into it");
  const auto end = static_cast<off_t>(kept);
  const bool cut = ::lseek(file_, 0, SEEK_END) != end;
  if ((cut && ::ftruncate(file_, end) != 0) || ::lseek(file_, end, SEEK_SET) != end) fail();
}

void OutputFile::open(int flags) {
  // Told apart by EPIPE and EFBIG.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  constexpr mode_t anyone = 0666;  // less the process's mask
  file_ =
      where_.empty() ? STDOUT_FILENO : ::open(where_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, anyone);
  if (where_.empty()) where_ = "standard output";
  if (file_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (file_ > STDERR_FILENO) ::close(file_);
}

void OutputFile::write(std::string_view lines) {
  const std::size_t written = write_all(file_, lines);
  if (written == lines.size()) return;
  take_back(file_, written);
  fail();
}

void OutputFile::close() {
  const int file = std::exchange(file_, -1);
  if (file > STDERR_FILENO && ::close(file) != 0 && errno != EINTR) fail();
}

bool OutputFile::is_terminal() const { return ::isatty(file_) != 0; }

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
