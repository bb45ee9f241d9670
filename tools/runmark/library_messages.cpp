#include "library_messages.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>

namespace runmark::cli {
namespace {

bool libraries_may_speak() { return std::getenv("OPENCV_LOG_LEVEL") != nullptr; }

std::mutex stderr_mutex;
int quiet_holders = 0;
int true_stderr = -1;

}  // namespace

void silence_libraries() {
  if (!libraries_may_speak()) {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  }
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);  // AV_LOG_QUIET
}

QuietStderr::QuietStderr() {
  const std::scoped_lock lock(stderr_mutex);
  if (quiet_holders++ > 0 || libraries_may_speak()) return;
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  true_stderr = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  if (true_stderr >= 0) ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

QuietStderr::~QuietStderr() {
  const std::scoped_lock lock(stderr_mutex);
  if (--quiet_holders > 0 || true_stderr < 0) return;
  ::dup2(true_stderr, STDERR_FILENO);
  ::close(true_stderr);
  true_stderr = -1;
}

}  // namespace runmark::cli
