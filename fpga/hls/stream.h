#pragma once

// Where the vendor's headers are, their streams; elsewhere bounded ones with the same calls, so that a
// program that would stand still in hardware stands still here, and says so.
#if __has_include(<hls_stream.h>)

#include <hls_stream.h>
#define RUNMARK_PROCESS(name, call) call

#else

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

/// A core of a dataflow region: a thread here, since a bounded stream needs both its ends at once.
#define RUNMARK_PROCESS(name, call) const std::jthread name([&] { call; })

namespace hls {

/// How long a core may wait for a stream before the program is held to stand still for ever.
inline std::chrono::milliseconds patience{20000};

/// A first-in first-out queue of `depth` values from one thread to another.
template <class T, std::size_t depth = 2>
class stream {
 public:
  explicit stream(const char* name = "stream") : name_(name) {}
  stream(const stream&) = delete;
  stream& operator=(const stream&) = delete;

  void write(const T& value) {
    std::unique_lock lock(mutex_);
    wait(lock, "full", [this] { return count_ < depth; });
    values_[(first_ + count_++) % depth] = value;
    if (count_ == 1) moved_.notify_one();
  }
  T read() {
    std::unique_lock lock(mutex_);
    wait(lock, "empty", [this] { return count_ > 0; });
    const T value = values_[first_];
    first_ = (first_ + 1) % depth;
    if (count_-- == depth) moved_.notify_one();
    return value;
  }
  [[nodiscard]] bool empty() const {
    const std::scoped_lock lock(mutex_);
    return count_ == 0;
  }

 private:
  template <class Ready>
  void wait(std::unique_lock<std::mutex>& lock, const char* what, Ready ready) {
    if (moved_.wait_for(lock, patience, ready)) return;
    std::fprintf(stderr, "deadlock: stream %s stays %s\n", name_, what);
    std::abort();
  }

  const char* name_;
  mutable std::mutex mutex_;
  std::condition_variable moved_;
  std::array<T, depth> values_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace hls

#endif
