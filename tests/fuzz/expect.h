#pragma once

#include <cstdio>
#include <cstdlib>

namespace runmark::fuzz {

/// Ends the program, which the fuzzer takes for a find, when what must hold for every input does not.
inline void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace runmark::fuzz
