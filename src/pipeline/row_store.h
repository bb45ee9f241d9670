#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace runmark {

/// The last few grey rows of a stream, in a ring.
class RowStore {
 public:
  RowStore(int max_width, int rows)
      : width_(static_cast<std::size_t>(max_width)),
        rows_(rows),
        grey_(width_ * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] std::uint8_t* row(int y) {
    return grey_.data() + static_cast<std::size_t>(y % rows_) * width_;
  }
  [[nodiscard]] std::size_t memory() const { return grey_.size(); }

 private:
  std::size_t width_;
  int rows_;
  std::vector<std::uint8_t> grey_;
};

}  // namespace runmark
