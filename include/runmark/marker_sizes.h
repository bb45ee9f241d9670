#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runmark/export.h"
#include "runmark/marker.h"
#include "runmark/result.h"

namespace runmark {

/// How large markers are: one size for all, others for some ids. Later ones win.
class MarkerSizes {
 public:
  /// Each text is "SIZE" (all markers), "ID=SIZE", "FIRST-LAST=SIZE", any of the two with "DICTIONARY:"
  /// before it, or "DICTIONARY:=SIZE". Errors: a text of another form, a size that is not positive.
  [[nodiscard]] static RUNMARK_EXPORT Result<MarkerSizes> parse(std::span<const std::string> texts);

  void set(std::string dictionary, int first_id, int last_id, double size) {
    entries_.push_back({std::move(dictionary), first_id, last_id, size});
  }

  /// Nothing when none was given for it.
  [[nodiscard]] RUNMARK_EXPORT std::optional<double> of(const Marker& marker) const;

 private:
  struct Entry {
    std::string dictionary;  // empty: any
    int first_id;
    int last_id;
    double size;
  };
  std::vector<Entry> entries_;
};

}  // namespace runmark
