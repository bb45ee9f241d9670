#pragma once

#include <chrono>
#include <cstdint>

namespace runmark::cli {

/// A bar with rate and time left on stderr, there only when stderr is a terminal and the work takes
/// longer than half a second.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` frames so far; `fraction` of the whole work, or negative when its end is not known.
  void update(std::int64_t done, double fraction);

  /// Takes the bar away, so that a line can be printed where it stands.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_ = false;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace runmark::cli
