#include <array>
#include <charconv>
#include <utility>

#include "runmark/print.h"

namespace runmark {
namespace {

struct Named {
  std::string_view name;
  double width;
  double height;
};

constexpr std::array papers{Named{"A3", 297, 420},        Named{"A4", 210, 297},
                            Named{"A5", 148, 210},        Named{"Letter", 215.9, 279.4},
                            Named{"Legal", 215.9, 355.6}, Named{"Tabloid", 279.4, 431.8}};

bool parse_length(std::string_view text, double& value) {
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end && value >= 20 && value <= 5000;
}

}  // namespace

Result<Paper> paper(std::string_view name) {
  constexpr std::string_view turned = "-landscape";
  const bool landscape = name.ends_with(turned);
  const std::string_view plain = landscape ? name.substr(0, name.size() - turned.size()) : name;
  for (const Named& known : papers) {
    if (known.name != plain) continue;
    return landscape ? Paper{known.height, known.width} : Paper{known.width, known.height};
  }
  Paper custom;
  const std::size_t cross = plain.find('x');
  if (cross != std::string_view::npos && !landscape && parse_length(plain.substr(0, cross), custom.width) &&
      parse_length(plain.substr(cross + 1), custom.height)) {
    return custom;
  }
  return Error{
      "'" + std::string(name) +
      "' is no paper: A3, A4, A5, Letter, Legal, Tabloid (with -landscape), or WIDTHxHEIGHT in millimetres"};
}

}  // namespace runmark
