#pragma once

#include <pybind11/numpy.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "detection.h"
#include "detector_pool.h"

namespace runmark::python {

/// A frame that comes row by row: a context manager. It borrows a detector of the pool's.
class RowStream {
 public:
  RowStream(std::shared_ptr<DetectorPool> pool, int width, int height, bool copy, std::string order);

  void enter();
  /// The markers these rows completed.
  std::vector<FoundMarker> push(const pybind11::object& rows);
  /// Ends the frame. Throws ValueError when rows are missing, unless the block is left by an exception.
  void exit(bool by_exception);
  [[nodiscard]] FoundMarkers found() const;

 private:
  [[nodiscard]] DetectorPool::Lease& open();

  std::shared_ptr<DetectorPool> pool_;
  int width_;
  int height_;
  bool copy_;
  std::string order_;
  std::mutex mutex_;  // of the detector: two threads may hold the stream
  std::optional<DetectorPool::Lease> detector_;
  std::vector<pybind11::array> kept_;  // rows that are not copied
  FoundMarkers found_;
  int rows_ = 0;
};

void bind_row_stream(pybind11::module_& module);

}  // namespace runmark::python
