#include "runmark/marker_sizes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace runmark {
namespace {

template <class T>
bool parse_number(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end && !text.empty();
}

}  // namespace

Result<MarkerSizes> MarkerSizes::parse(std::span<const std::string> texts) {
  MarkerSizes sizes;
  for (const std::string& text : texts) {
    const Error wrong{"'" + text +
                      "' is not a marker size: SIZE, ID=SIZE, FIRST-LAST=SIZE, DICTIONARY:ID=SIZE"};
    std::string_view rest = text;
    std::string dictionary;
    int first = 0;
    int last = std::numeric_limits<int>::max();
    if (const std::size_t equals = rest.rfind('='); equals != std::string_view::npos) {
      std::string_view ids = rest.substr(0, equals);
      rest = rest.substr(equals + 1);
      const std::size_t colon = ids.rfind(':');
      if (colon != std::string_view::npos) {
        dictionary = ids.substr(0, colon);
        ids = ids.substr(colon + 1);
      }
      if (!ids.empty()) {
        const std::size_t dash = ids.find('-');
        if (!parse_number(ids.substr(0, dash), first)) return wrong;
        last = first;
        if (dash != std::string_view::npos && !parse_number(ids.substr(dash + 1), last)) return wrong;
        if (last < first) return wrong;
      } else if (dictionary.empty()) {
        return wrong;
      }
    }
    double size = 0;
    if (!parse_number(rest, size) || !std::isfinite(size) || size <= 0) return wrong;
    sizes.set(dictionary, first, last, size);
  }
  return sizes;
}

std::optional<double> MarkerSizes::of(const Marker& marker) const {
  const auto entry = std::find_if(entries_.rbegin(), entries_.rend(), [&](const Entry& e) {
    const bool named = e.dictionary.empty() || e.dictionary == marker.dictionary;
    return named && marker.id >= e.first_id && marker.id <= e.last_id;
  });
  if (entry == entries_.rend()) return {};
  return entry->size;
}

}  // namespace runmark
