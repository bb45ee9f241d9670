#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

#include "dictionary/code_distance.h"
#include "dictionary/edit_distance.h"
#include "files/read_text.h"
#include "runmark/dictionary.h"

namespace runmark {

// The texts of data/dictionaries, compiled in by cmake/embed_codes.cmake.
namespace codes {
extern const std::string_view ARUCO_MIP_16h3, ARUCO_MIP_25h7, ARUCO_MIP_36h12, DICT_4X4_1000, DICT_5X5_1000,
    DICT_6X6_1000, DICT_7X7_1000, DICT_ARUCO_ORIGINAL, tag16h5, tag25h9, tag36h10, tag36h11, tagCircle21h7,
    tagCircle49h12, tagCustom48h12, tagStandard41h12, tagStandard52h13;
}

namespace {

constexpr std::size_t all = 0;

struct Builtin {
  std::string_view name;
  const std::string_view& text;
  std::size_t count;  // the first so many codes of the text, or all
};

constexpr std::array builtins{
    Builtin{"ARUCO_MIP_16h3", codes::ARUCO_MIP_16h3, all},
    Builtin{"ARUCO_MIP_25h7", codes::ARUCO_MIP_25h7, all},
    Builtin{"ARUCO_MIP_36h12", codes::ARUCO_MIP_36h12, all},
    Builtin{"DICT_4X4_100", codes::DICT_4X4_1000, 100},
    Builtin{"DICT_4X4_1000", codes::DICT_4X4_1000, all},
    Builtin{"DICT_4X4_250", codes::DICT_4X4_1000, 250},
    Builtin{"DICT_4X4_50", codes::DICT_4X4_1000, 50},
    Builtin{"DICT_5X5_100", codes::DICT_5X5_1000, 100},
    Builtin{"DICT_5X5_1000", codes::DICT_5X5_1000, all},
    Builtin{"DICT_5X5_250", codes::DICT_5X5_1000, 250},
    Builtin{"DICT_5X5_50", codes::DICT_5X5_1000, 50},
    Builtin{"DICT_6X6_100", codes::DICT_6X6_1000, 100},
    Builtin{"DICT_6X6_1000", codes::DICT_6X6_1000, all},
    Builtin{"DICT_6X6_250", codes::DICT_6X6_1000, 250},
    Builtin{"DICT_6X6_50", codes::DICT_6X6_1000, 50},
    Builtin{"DICT_7X7_100", codes::DICT_7X7_1000, 100},
    Builtin{"DICT_7X7_1000", codes::DICT_7X7_1000, all},
    Builtin{"DICT_7X7_250", codes::DICT_7X7_1000, 250},
    Builtin{"DICT_7X7_50", codes::DICT_7X7_1000, 50},
    Builtin{"DICT_APRILTAG_16h5", codes::tag16h5, all},
    Builtin{"DICT_APRILTAG_25h9", codes::tag25h9, all},
    Builtin{"DICT_APRILTAG_36h10", codes::tag36h10, all},
    Builtin{"DICT_APRILTAG_36h11", codes::tag36h11, all},
    Builtin{"DICT_ARUCO_MIP_36h12", codes::ARUCO_MIP_36h12, all},
    Builtin{"DICT_ARUCO_ORIGINAL", codes::DICT_ARUCO_ORIGINAL, all},
    Builtin{"tag16h5", codes::tag16h5, all},
    Builtin{"tag25h9", codes::tag25h9, all},
    Builtin{"tag36h10", codes::tag36h10, all},
    Builtin{"tag36h11", codes::tag36h11, all},
    Builtin{"tagCircle21h7", codes::tagCircle21h7, all},
    Builtin{"tagCircle49h12", codes::tagCircle49h12, all},
    Builtin{"tagCustom48h12", codes::tagCustom48h12, all},
    Builtin{"tagStandard41h12", codes::tagStandard41h12, all},
    Builtin{"tagStandard52h13", codes::tagStandard52h13, all},
};

constexpr auto names = [] {
  std::array<std::string_view, builtins.size()> list{};
  std::ranges::transform(builtins, list.begin(), &Builtin::name);
  return list;
}();
static_assert(std::ranges::is_sorted(names));

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const std::string_view> dictionary_names() { return names; }

Result<Dictionary> builtin_dictionary(std::string_view name) {
  const auto found = std::ranges::find_if(
      builtins, [&](const Builtin& builtin) { return same_letters(builtin.name, name); });
  if (found == builtins.end()) {
    return Error{"unknown dictionary '" + std::string(name) + "'; did you mean " +
                 closest_names(name, names) + "?"};
  }
  auto dictionary = parse_codes(found->text, std::string(found->name));
  if (dictionary && found->count != all) {
    dictionary->codes.resize(found->count);
    dictionary->distance = least_distance(*dictionary);
    dictionary->corrected_bits =
        safe_corrected_bits(dictionary->cells.size(), found->count, dictionary->distance);
  }
  return dictionary;
}

Result<Dictionary> load_dictionary(const std::string& name_or_path) {
  constexpr std::string_view ending = ".codes";
  if (!name_or_path.ends_with(ending)) return builtin_dictionary(name_or_path);
  auto text = read_text(name_or_path, 8);  // five times what 65,536 codes take
  if (!text) return Error{text.error()};
  auto dictionary = parse_codes(*text, name_or_path);  // errors say which file
  if (!dictionary) return dictionary;
  const std::size_t slash = name_or_path.find_last_of('/');
  dictionary->name = name_or_path.substr(slash == std::string::npos ? 0 : slash + 1);
  dictionary->name.resize(dictionary->name.size() - ending.size());
  return dictionary;
}

}  // namespace runmark
