#include "detector_settings.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "errors.h"

namespace runmark::cli {
namespace {

// What people print most. Larger sets of 4x4 codes are left out: their few cells are found by chance on
// other markers.
constexpr std::array default_dictionaries{"tag36h11",     "ARUCO_MIP_36h12", "DICT_4X4_50",
                                          "DICT_5X5_100", "DICT_6X6_250",    "DICT_7X7_100"};
// The paper's 8x8 grid reads 6x6 cells and their border.
constexpr std::array paper_dictionaries{"tag36h11", "ARUCO_MIP_36h12", "DICT_6X6_250"};

template <std::size_t N>
std::string joined(const std::array<const char*, N>& names) {
  std::string text;
  for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

void add_region(CLI::App& command, Options& options) {
  command
      .add_option_function<std::vector<int>>(
          "--region",
          [&options](const std::vector<int>& r) {
            options.region = {r[0], r[1], r[2], r[3]};
          },
          "Look only inside this part of the frame, in pixels")
      ->delimiter(',')
      ->expected(4)
      ->allow_extra_args(false)
      ->type_name("X,Y,W,H");
}

void add_filter(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--filter",
          [&options](const std::string& cases) {
            options.filter = filter_none;
            if (cases == "none") return;
            for (const char letter : cases) {
              if (letter < 'a' || letter > 'f') {
                throw CLI::ValidationError("--filter",
                                           "'" + cases + "' is neither none nor letters from a to f");
              }
              options.filter = static_cast<std::uint8_t>(options.filter | 1U << (letter - 'a'));
            }
          },
          "Cases of the paper's Fig. 2 mended before contours are followed; without it abcdef in the paper "
          "pipeline, none in the others")
      ->type_name("none|abcdef");
}

}  // namespace

void add_detector_options(CLI::App& command, DetectorSettings& settings) {
  Options& options = settings.options;
  command
      .add_option("-d,--dict", settings.dictionary_names,
                  "Dictionary to look for: a built-in name or the path of a .codes file; may be given "
                  "several times. Without it: " +
                      joined(default_dictionaries) + " (--pipeline paper: " + joined(paper_dictionaries) +
                      ")")
      ->allow_extra_args(false)
      ->type_name("NAME");
  const std::map<std::string, Pipeline> pipelines{
      {"paper", Pipeline::paper}, {"hardware", Pipeline::hardware}, {"default", Pipeline::standard}};
  command.add_option("--pipeline", options.pipeline, "How the five cores are put together")
      ->transform(CLI::CheckedTransformer(pipelines).description(""))
      ->type_name("paper|hardware|default");
  command.add_flag("--inverted", options.inverted, "Also look for white-on-black markers");
  command.add_option("--min-size", options.min_marker_size, "Least side of a marker, in pixels")
      ->capture_default_str();
  command.add_option("--max-size", options.max_marker_size, "Largest side of a marker, in pixels")
      ->capture_default_str();
  command
      .add_option("--corrected-bits", options.corrected_bits,
                  "Wrong bits corrected in a code; without it, each dictionary's safe number")
      ->check(CLI::Range(0, 64).description(""));
  command.add_option("--min-margin", options.min_margin, "Least decision margin of a marker, 0 to 0.5")
      ->capture_default_str();
  command
      .add_option("--min-contrast", options.min_contrast,
                  "Least difference of grey levels between black and white; in the dark two fifths of it")
      ->capture_default_str();
  command.add_option("--octaves", options.octaves, "How often the rows are halved to find large markers")
      ->capture_default_str();
  command.add_option("--threshold", options.fixed_threshold, "Paper pipeline: grey levels below it are dark")
      ->capture_default_str();
  command.add_flag("--above-is-dark", options.above_is_dark,
                   "Paper pipeline: levels at or above the threshold are dark instead");
  command
      .add_option("--corner-offset", options.corner_offset,
                  "Paper pipeline: offset across the direction of travel that makes a corner, in pixels")
      ->capture_default_str();
  const std::map<std::string, Connectivity> connectivities{{"4", Connectivity::four},
                                                           {"8", Connectivity::eight}};
  command
      .add_option("--connectivity", options.connectivity,
                  "Whether dark pixels that meet at a corner only touch (8) or not (4); without it 8 in the "
                  "paper pipeline, 4 in the others")
      ->transform(CLI::CheckedTransformer(connectivities).description(""))
      ->type_name("4|8");
  add_filter(command, options);
  add_region(command, options);
}

void add_dictionaries_of(const Board& board, DetectorSettings& settings) {
  std::vector<std::string>& names = settings.dictionary_names;
  for (const BoardMarker& marker : board.markers) {
    if (!marker.dictionary.empty() && std::ranges::count(names, marker.dictionary) == 0) {
      names.push_back(marker.dictionary);
    }
  }
}

std::vector<Dictionary> load_dictionaries(const DetectorSettings& settings) {
  std::vector<std::string> names = settings.dictionary_names;
  if (names.empty() && settings.options.pipeline == Pipeline::paper) {
    names.assign(paper_dictionaries.begin(), paper_dictionaries.end());
  } else if (names.empty()) {
    names.assign(default_dictionaries.begin(), default_dictionaries.end());
  }
  std::vector<Dictionary> dictionaries;
  for (const std::string& name : names) dictionaries.push_back(value_or_throw(load_dictionary(name)));
  return dictionaries;
}

}  // namespace runmark::cli
