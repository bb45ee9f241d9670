#include "errors.h"

#include <cstdio>
#include <string>

namespace runmark::cli {

void print_error(std::string_view message, std::string_view program) {
  std::string line = std::string(program) + ": ";
  for (const char c : message) {
    if (c != '\n') {
      line += c;
    } else if (!line.ends_with("; ")) {
      line += "; ";
    }
  }
  if (line.ends_with("; ")) line.resize(line.size() - 2);
  line += '\n';
  // One write, so that lines of several processes do not mix.
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace runmark::cli
