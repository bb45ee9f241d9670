#include "id_list.h"

#include <charconv>
#include <string_view>

#include "errors.h"

namespace runmark::cli {
namespace {

int parse_id(std::string_view text, const std::string& all) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < 0)
    throw UserError("'" + all + "' is no list of ids like 0-11,15");
  return value;
}

}  // namespace

std::vector<int> parse_ids(const std::string& text) {
  constexpr int most = 100000;
  std::vector<int> ids;
  std::string_view rest = text;
  for (;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    const std::size_t dash = part.find('-');
    const int first = parse_id(part.substr(0, dash), text);
    const int last = dash == std::string_view::npos ? first : parse_id(part.substr(dash + 1), text);
    if (last < first || last - first >= most)
      throw UserError("'" + text + "' is no list of ids like 0-11,15");
    for (int id = first; id <= last; ++id) ids.push_back(id);
    if (comma == std::string_view::npos) return ids;
    rest = rest.substr(comma + 1);
  }
}

}  // namespace runmark::cli
