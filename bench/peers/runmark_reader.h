#pragma once

#include "bench/peers/reader.h"

namespace runmark::bench {

/// Our own detector with its default options.
[[nodiscard]] std::unique_ptr<Reader> make_runmark_reader(const Task& task);

}  // namespace runmark::bench
