#include "row_stream.h"

#include <pybind11/stl.h>

#include "image.h"

namespace py = pybind11;

namespace runmark::python {

RowStream::RowStream(std::shared_ptr<DetectorPool> pool, int width, int height, bool copy, std::string order)
    : pool_(std::move(pool)), width_(width), height_(height), copy_(copy), order_(std::move(order)) {
  constexpr int most_side = 65535;
  if (width < 1 || width > most_side || height < 1 || height > most_side) {
    throw py::value_error("stream of " + std::to_string(width) + " x " + std::to_string(height) +
                          " pixels: sides must be 1 to 65535");
  }
  found_.width = width;
  found_.height = height;
  found_.dictionaries = pool_->dictionaries();
}

DetectorPool::Lease& RowStream::open() {
  if (!detector_) throw py::value_error("the stream is not open: use it in a with statement");
  return *detector_;
}

void RowStream::enter() {
  if (detector_) throw py::value_error("the stream is open already");
  Result<DetectorPool::Lease> lease = pool_->borrow(width_, height_, copy_);
  if (!lease) throw py::value_error(lease.error());
  detector_.emplace(*std::move(lease));
  found_.markers.clear();
  found_.rejected.clear();
  rows_ = 0;
  if (const Status status = open()->begin(width_, height_); status != Status::ok) {
    throw py::value_error(std::string(describe(status)));
  }
}

std::vector<FoundMarker> RowStream::push(const py::object& rows) {
  ArrayView array = view_of(rows, order_, "rows");
  if (array.view.width != width_ || array.view.height > height_ - rows_) {
    throw py::value_error("rows: " + std::to_string(array.view.height) + " of " +
                          std::to_string(array.view.width) + " pixels, but " +
                          std::to_string(height_ - rows_) + " of " + std::to_string(width_) +
                          " pixels are wanted");
  }
  DetectorPool::Lease& detector = open();
  if (!copy_) kept_.push_back(array.memory);
  Status status = Status::ok;
  std::vector<FoundMarker> fresh;
  {
    const py::gil_scoped_release nogil;
    const std::scoped_lock lock(mutex_);
    status = detector->push_rows(array.view);
    const std::size_t known = found_.markers.size();
    found_.add(detector->markers().subspan(known));
    for (std::size_t i = known; i < found_.markers.size(); ++i) {
      fresh.push_back({found_.markers[i], found_.dictionaries});
    }
  }
  if (status != Status::ok) {
    throw py::value_error("rows: " + std::string(describe(status)) + "; all rows must be of one format");
  }
  rows_ += array.view.height;
  return fresh;
}

void RowStream::exit(bool by_exception) {
  DetectorPool::Lease& detector = open();
  const std::scoped_lock lock(mutex_);
  const Status status = detector->end();
  found_.finish(*detector);
  detector_.reset();
  kept_.clear();
  if (status != Status::ok && !by_exception) {
    throw py::value_error("the stream ended after " + std::to_string(rows_) + " of " +
                          std::to_string(height_) + " rows");
  }
}

FoundMarkers RowStream::found() const { return found_; }

void bind_row_stream(py::module_& module) {
  py::class_<RowStream>(
      module, "RowStream",
      "A frame that comes row by row. Detector.stream makes one; the with statement opens it.")
      .def("__enter__",
           [](py::object& self) {
             self.cast<RowStream&>().enter();
             return self;
           })
      .def("__exit__", [](RowStream& self, const py::object& type, const py::object&,
                          const py::object&) { self.exit(!type.is_none()); })
      .def("push", &RowStream::push, py::arg("rows"),
           "rows: uint8 (n, W) or (n, W, 3), the next n rows. Gives the markers these rows completed: "
           "their last row and a few below it are in. No marker is ever taken back. The GIL is released "
           "meanwhile.")
      .def_property_readonly("detection", &RowStream::found, "All markers so far; complete after the block.");
}

}  // namespace runmark::python
