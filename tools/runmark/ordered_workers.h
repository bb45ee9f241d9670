#pragma once

#include <csignal>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace runmark::cli {

/// Items are worked on by several threads and put out by one more, in the order in which they came. Few
/// are under way at once, so that a fast reader does not fill the memory.
template <class Item>
class OrderedWorkers {
 public:
  /// `work(worker, item)` runs in thread `worker` and must not throw; `put(item)` sees one item at a time.
  /// When `put` throws, nothing more is put out, and `on_failure` is called so that a reader can be woken.
  OrderedWorkers(std::size_t workers, std::function<void(std::size_t, Item&)> work,
                 std::function<void(Item&)> put, std::function<void()> on_failure)
      : most_(2 * workers + 2),
        work_(std::move(work)),
        put_(std::move(put)),
        on_failure_(std::move(on_failure)) {
    const SignalsHeld held;
    for (std::size_t i = 0; i < workers; ++i) threads_.emplace_back([this, i] { run_worker(i); });
    threads_.emplace_back([this] { run_output(); });
  }
  ~OrderedWorkers() {
    close();
    join();
  }
  OrderedWorkers(const OrderedWorkers&) = delete;
  OrderedWorkers& operator=(const OrderedWorkers&) = delete;

  /// Waits for a free place. False: `put` has thrown, no more items are wanted.
  [[nodiscard]] bool push(Item item) {
    std::unique_lock lock(mutex_);
    place_free_.wait(lock, [this] { return entries_.size() < most_ || failure_; });
    if (failure_) return false;
    entries_.push_back({std::move(item), false});
    work_there_.notify_one();
    return true;
  }

  /// All that was pushed is put out, or what `put` threw is thrown here.
  void finish() {
    close();
    join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  struct Entry {
    Item item;
    bool done = false;
  };

  /// Threads made meanwhile leave Ctrl-C to the main thread, whose waiting for input it is to end.
  class SignalsHeld {
   public:
    SignalsHeld() {
      sigset_t signals;
      sigemptyset(&signals);
      sigaddset(&signals, SIGINT);
      sigaddset(&signals, SIGTERM);
      sigaddset(&signals, SIGHUP);
      pthread_sigmask(SIG_BLOCK, &signals, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

   private:
    sigset_t before_{};
  };

  void run_worker(std::size_t worker) {
    std::unique_lock lock(mutex_);
    while (true) {
      work_there_.wait(lock, [this] { return taken_ < entries_.size() || closed_ || failure_; });
      if (failure_ || taken_ == entries_.size()) return;
      Entry& entry = entries_[taken_++];  // a deque's entries stay where they are
      lock.unlock();
      work_(worker, entry.item);
      lock.lock();
      entry.done = true;
      if (&entry == &entries_.front()) first_done_.notify_one();
    }
  }

  void run_output() {
    std::unique_lock lock(mutex_);
    while (true) {
      first_done_.wait(lock, [this] { return entries_.empty() ? closed_ : entries_.front().done; });
      if (entries_.empty()) return;
      Entry& entry = entries_.front();
      lock.unlock();
      std::exception_ptr failure;
      try {
        put_(entry.item);
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      if (failure) return fail(failure);
      entries_.pop_front();
      --taken_;
      place_free_.notify_one();
    }
  }

  void fail(const std::exception_ptr& failure) {
    failure_ = failure;
    place_free_.notify_all();
    work_there_.notify_all();
    on_failure_();
  }

  void close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    work_there_.notify_all();
    first_done_.notify_all();
  }

  void join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

  const std::size_t most_;
  std::function<void(std::size_t, Item&)> work_;
  std::function<void(Item&)> put_;
  std::function<void()> on_failure_;
  std::mutex mutex_;  // of all below
  std::condition_variable place_free_, work_there_, first_done_;
  std::deque<Entry> entries_;  // pushed and not yet put out, in order
  std::size_t taken_ = 0;      // of them, those a worker has
  bool closed_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace runmark::cli
