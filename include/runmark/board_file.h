#pragma once

#include <string>
#include <string_view>

#include "runmark/board.h"
#include "runmark/export.h"
#include "runmark/result.h"

namespace runmark {

/// Reads a board from the text of a JSON file, docs/boards.md has the format: a grid, a ChArUco board, or
/// markers anywhere in space. Errors say what is missing or wrong and where.
[[nodiscard]] RUNMARK_EXPORT Result<Board> parse_board(std::string_view text);

/// A board by its description, "charuco:DICTIONARY:COLUMNSxROWS:SQUARE:MARKER[:legacy][:turned]",
/// "grid:DICTIONARY:COLUMNSxROWS:MARKER:GAP", or by the path of a JSON file when the argument ends in
/// ".json".
[[nodiscard]] RUNMARK_EXPORT Result<Board> load_board(const std::string& description_or_path);

}  // namespace runmark
