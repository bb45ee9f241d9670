#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runmark/export.h"
#include "runmark/result.h"

namespace runmark {

/// A cell of a marker. The corners of the detected square are those of the cells (0, 0) to
/// (width - 1, width - 1); x goes right and y down on the marker as it is drawn. Cells outside that
/// range lie outside the square (AprilTag 3's Standard and Custom families have some).
struct Cell {
  std::int8_t x = 0;
  std::int8_t y = 0;
  friend constexpr bool operator==(Cell, Cell) = default;
};

/// What is found round the data of a marker.
enum class Border : std::uint8_t {
  black,     ///< one ring of black cells just inside the square, white around it (ArUco, AprilTag 2)
  reversed,  ///< one ring of white cells just inside the square, black around it (AprilTag 3)
  included,  ///< none of its own: the code describes every cell of the square (8x8 templates)
};

/// A set of markers as data: where the data cells are and what each code puts into them.
struct Dictionary {
  std::string name;  ///< as asked for: DICT_4X4_50, tag36h11, ARUCO_MIP_36h12, a file's stem
  int width = 0;     ///< cells along the side of the detected square, border included
  Border border = Border::black;
  std::vector<Cell> cells;  ///< the data cells, at most 64; row-major unless the family says otherwise
  std::vector<std::uint64_t> codes;  ///< one code an id; cells[0] is the most significant of
                                     ///< cells.size() bits; 1 is white
  int corrected_bits = 0;            ///< how many wrong bits may be corrected: safe by default
  int distance = 0;                  ///< the least Hamming distance of two codes in any rotation
};

/// Names of the dictionaries that come with runmark, sorted.
[[nodiscard]] RUNMARK_EXPORT std::span<const std::string_view> dictionary_names();

/// The built-in dictionary of that name (OpenCV's, AprilTag's and MIP names; an AprilTag family has
/// two: DICT_APRILTAG_36h11 is tag36h11), or an error that names close ones.
[[nodiscard]] RUNMARK_EXPORT Result<Dictionary> builtin_dictionary(std::string_view name);

/// Reads the text of a .codes file; see docs/dictionaries.md for the format. `name` becomes the
/// dictionary's name. Errors give the line.
[[nodiscard]] RUNMARK_EXPORT Result<Dictionary> parse_codes(std::string_view text, std::string name);

/// A built-in name, or the path of a .codes file when the argument ends in ".codes".
[[nodiscard]] RUNMARK_EXPORT Result<Dictionary> load_dictionary(const std::string& name_or_path);

}  // namespace runmark
