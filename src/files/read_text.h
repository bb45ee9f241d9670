#pragma once

#include <cstddef>
#include <fstream>
#include <string>

#include "runmark/result.h"

namespace runmark {

/// All of a text file that is no larger than it can sensibly be: what is endless or was never meant must not
/// fill the memory.
inline Result<std::string> read_text(const std::string& path, std::size_t most_megabytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path + ": cannot be read"};
  const std::size_t most = most_megabytes << 20U;
  std::string text;
  std::string block(std::size_t{1} << 16U, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > most)
      return Error{path + ": larger than " + std::to_string(most_megabytes) +
                   " MB, which no such file needs to be"};
  }
  if (file.bad() || text.empty()) return Error{path + ": empty or not a readable file"};
  return text;
}

}  // namespace runmark
