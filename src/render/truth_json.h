#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "render/truth.h"

namespace runmark::render {

/// One entry of a truth file, see docs/render.md: what was rendered into the file `image`.
[[nodiscard]] nlohmann::ordered_json to_json(const FrameTruth& truth, const std::string& image);

/// A truth file: an array with one entry a line.
[[nodiscard]] std::string truth_file(const std::vector<nlohmann::ordered_json>& entries);

}  // namespace runmark::render
