#pragma once

#include "runmark/options.h"
#include "runmark/result.h"
#include "runmark/runmark.h"

namespace runmark::c_api {

/// The options, or what does not fit into C++'s; the detector checks their ranges.
[[nodiscard]] Result<Options> to_options(const runmark_options& c);

}  // namespace runmark::c_api
