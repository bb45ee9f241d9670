#include "detector_pool.h"

#include <algorithm>

#include "pipeline/size_class.h"

namespace runmark::python {

Result<DetectorPool::Lease> DetectorPool::borrow(int width, int height, bool copy_rows) {
  Options wanted = options_;
  wanted.max_width = size_class(width);
  wanted.max_height = size_class(height);
  wanted.copy_rows = copy_rows;
  {
    const std::scoped_lock lock(mutex_);
    const auto fits = [&](const Detector& detector) {
      const Options& o = detector.options();
      return o.max_width == wanted.max_width && o.max_height == wanted.max_height && o.copy_rows == copy_rows;
    };
    const auto found = std::ranges::find_if(idle_, fits);
    if (found != idle_.end()) {
      Detector detector = std::move(*found);
      idle_.erase(found);
      return Lease(*this, std::move(detector));
    }
  }
  Result<Detector> made = Detector::create(wanted, *dictionaries_);
  if (!made) return Error{made.error()};
  return Lease(*this, *std::move(made));
}

void DetectorPool::give_back(Detector detector) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(detector));
}

std::size_t DetectorPool::memory() const {
  const std::scoped_lock lock(mutex_);
  std::size_t sum = 0;
  for (const Detector& detector : idle_) sum += detector.memory();
  return sum;
}

}  // namespace runmark::python
