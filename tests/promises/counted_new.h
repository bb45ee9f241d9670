#pragma once

#include <cstdint>

namespace runmark::test {

/// How often this program has asked for memory by operator new so far.
[[nodiscard]] std::uint64_t allocations();

}  // namespace runmark::test
