#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "contour/record.h"

namespace runmark {

/// The records of all chains, in memory of fixed size. Free ones stand in a list, so a whole chain comes
/// back in one step.
class RecordPool {
 public:
  /// At most 65535 records: no_record is not an index.
  explicit RecordPool(std::span<Record> storage) : records_(storage) {}

  /// Makes every record free and forgets the peak. Records never used since are free without being in
  /// the list.
  void reset() {
    free_ = no_record;
    untouched_ = 0;
    alive_ = 0;
    peak_ = 0;
  }

  /// A record holding these values, or no_record when none is free.
  [[nodiscard]] RecordIndex take(std::uint16_t x, std::uint16_t y, RecordIndex next) {
    RecordIndex index = free_;
    if (index != no_record) {
      free_ = records_[index].next;
    } else {
      if (untouched_ == records_.size()) return no_record;
      index = static_cast<RecordIndex>(untouched_++);
    }
    records_[index] = {x, y, next};
    ++alive_;
    return index;
  }

  /// Frees the list from `head` to `tail`, `count` records.
  void give_back(RecordIndex head, RecordIndex tail, std::size_t count) {
    records_[tail].next = free_;
    free_ = head;
    peak_ = peak();
    alive_ -= count;
  }

  void link(RecordIndex from, RecordIndex to) { records_[from].next = to; }
  [[nodiscard]] const Record& operator[](RecordIndex index) const { return records_[index]; }
  [[nodiscard]] std::size_t alive() const { return alive_; }
  /// The most that were alive at once since the reset.
  [[nodiscard]] std::size_t peak() const { return std::max(peak_, alive_); }

 private:
  std::span<Record> records_;
  RecordIndex free_ = no_record;
  std::size_t untouched_ = 0;
  std::size_t alive_ = 0;
  std::size_t peak_ = 0;  // when records were last given back
};

}  // namespace runmark
