#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "runmark/detector.h"

namespace runmark::python {

/// Detectors with the same options for frames of any size and any number of threads: who needs one borrows
/// it. There is one for each power of two of width and height, so what a frame gives does not depend on the
/// frames before it; and as many of them as threads were busy at once. Safe to use from several threads.
class DetectorPool {
 public:
  /// `options` without its sizes and copy_rows.
  DetectorPool(const Options& options, std::shared_ptr<const std::vector<Dictionary>> dictionaries)
      : options_(options), dictionaries_(std::move(dictionaries)) {}

  /// A borrowed detector; it goes back when this ends. The pool must outlive it.
  class Lease {
   public:
    Lease(DetectorPool& pool, Detector detector) : pool_(&pool), detector_(std::move(detector)) {}
    Lease(Lease&& other) noexcept
        : pool_(std::exchange(other.pool_, nullptr)), detector_(std::move(other.detector_)) {}
    Lease& operator=(Lease&&) = delete;
    ~Lease() {
      if (pool_ != nullptr) pool_->give_back(std::move(detector_));
    }
    [[nodiscard]] Detector* operator->() { return &detector_; }
    [[nodiscard]] const Detector& operator*() const { return detector_; }

   private:
    DetectorPool* pool_;
    Detector detector_;
  };

  /// Errors: as of Detector::create.
  [[nodiscard]] Result<Lease> borrow(int width, int height, bool copy_rows);

  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] const std::shared_ptr<const std::vector<Dictionary>>& dictionaries() const {
    return dictionaries_;
  }
  /// Bytes of the detectors that are not borrowed.
  [[nodiscard]] std::size_t memory() const;

 private:
  void give_back(Detector detector);

  Options options_;
  std::shared_ptr<const std::vector<Dictionary>> dictionaries_;
  mutable std::mutex mutex_;  // of the one below
  std::vector<Detector> idle_;
};

}  // namespace runmark::python
