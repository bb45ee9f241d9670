#pragma once

#include <string>
#include <vector>

namespace runmark::cli {

/// The ids of "0-11,15,20-22", in that order. Throws UserError.
[[nodiscard]] std::vector<int> parse_ids(const std::string& text);

}  // namespace runmark::cli
