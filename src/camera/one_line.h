#pragma once

#include <string>

namespace runmark {

/// A message that repeats what stands in a file may hold anything: control characters become blanks.
inline std::string one_line(std::string message) {
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return message;
}

}  // namespace runmark
