#include "interrupt.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace runmark::cli {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

// Filled once something is to end the waiting: unlike a signal, it cannot come just before the wait begins.
std::array<int, 2> stop_pipe{-1, -1};

extern "C" void on_interrupt(int /*signal*/) {
  const int error = errno;
  interrupt_flag = 1;
  stop_waiting();
  errno = error;
}

}  // namespace

void catch_interrupts() {
  // Without the pipe Ctrl-C is seen after the next frame.
  if (stop_pipe[0] < 0 && ::pipe2(stop_pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) stop_pipe = {-1, -1};
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  // No SA_RESTART: a read that waits for a camera returns, and the flag is seen.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // Of a terminal that is closed; nohup has it ignored.
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

bool interrupted() { return interrupt_flag != 0; }

bool wait_for_input(int file) {
  std::array<pollfd, 2> files{{{file, POLLIN, 0}, {stop_pipe[0], POLLIN, 0}}};
  while (::poll(files.data(), files.size(), -1) < 0) {
    if (errno != EINTR) return true;  // the read itself will say what is wrong
  }
  return files[1].revents == 0;
}

void stop_waiting() {
  const char byte = 0;
  // A pipe that is full has said it already.
  [[maybe_unused]] const ssize_t written = ::write(stop_pipe[1], &byte, 1);
}

}  // namespace runmark::cli
