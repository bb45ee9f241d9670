// The .codes text format: see docs/dictionaries.md.

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dictionary/cell_rotation.h"
#include "dictionary/check_dictionary.h"
#include "dictionary/code_distance.h"
#include "runmark/dictionary.h"

namespace runmark {

namespace {

// Up to here the distance is worked out when the file does not state it: 0.1 s at most.
constexpr std::size_t most_codes_compared = 8192;

template <class Number>
std::optional<Number> number(std::string_view text, int base = 10) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, base);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

/// Takes the next word off the front of `line`; empty when there is none.
std::string_view take_word(std::string_view& line) {
  constexpr std::string_view blanks = " \t";
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

class CodesParser {
 public:
  explicit CodesParser(std::string name) { dictionary_.name = std::move(name); }

  Result<Dictionary> parse(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      line = line.substr(0, line.find('#'));
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (auto problem = read(line)) return Error{at_line(line_, *problem)};
    }
    if (auto problem = finish()) return Error{*problem};
    return std::move(dictionary_);
  }

 private:
  using Problem = std::optional<std::string>;

  [[nodiscard]] std::string at_line(int line, const std::string& problem) const {
    return dictionary_.name + ", line " + std::to_string(line) + ": " + problem;
  }

  Problem read(std::string_view line) {
    const std::string_view word = take_word(line);
    if (word.empty()) return std::nullopt;
    if (per_side_ == 0) return read_head(word, line);
    if (word == "border" || word == "distance" || word == "cells" || word == "symmetric") {
      if (!code_lines_.empty()) return "'" + std::string(word) + "' must come before the codes";
      if (word == "border") return read_border(line);
      if (word == "distance") return read_distance(line);
      if (word == "cells") return read_cells(line);
      return read_symmetric(line);
    }
    return read_code(word, line);
  }

  Problem read_head(std::string_view first, std::string_view rest) {
    const auto per_side = number<int>(first);
    const auto corrected = number<int>(take_word(rest));
    if (!per_side || !corrected || !take_word(rest).empty()) {
      return "expected two numbers, cells per side and corrected bits";
    }
    if (*per_side < 2 || *per_side > max_cells_per_side) {
      return "cells per side must be 2 to " + std::to_string(max_cells_per_side);
    }
    if (*corrected < 0 || *corrected > static_cast<int>(max_data_cells)) {
      return "corrected bits must be 0 to " + std::to_string(max_data_cells);
    }
    per_side_ = *per_side;
    dictionary_.corrected_bits = *corrected;
    return std::nullopt;
  }

  Problem read_border(std::string_view rest) {
    const std::string_view kind = take_word(rest);
    if (border_line_ != 0) return "second 'border' line";
    if (!take_word(rest).empty()) return "more than one kind of border";
    border_line_ = line_;
    if (kind == "black")
      dictionary_.border = Border::black;
    else if (kind == "reversed")
      dictionary_.border = Border::reversed;
    else if (kind == "included")
      dictionary_.border = Border::included;
    else
      return "border must be black, reversed or included";
    return std::nullopt;
  }

  Problem read_distance(std::string_view rest) {
    const auto distance = number<int>(take_word(rest));
    if (stated_distance_) return "second 'distance' line";
    if (!distance || *distance < 1 || *distance > static_cast<int>(max_data_cells) ||
        !take_word(rest).empty()) {
      return "distance must be one number, 1 to " + std::to_string(max_data_cells);
    }
    stated_distance_ = *distance;
    return std::nullopt;
  }

  Problem read_cells(std::string_view rest) {
    cells_line_ = line_;
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest)) {
      const std::size_t comma = std::min(word.find(','), word.size());
      const auto x = number<std::int8_t>(word.substr(0, comma));
      const auto y = number<std::int8_t>(word.substr(std::min(comma + 1, word.size())));
      if (!x || !y) return quoted(word) + " is not a cell: x,y";
      dictionary_.cells.push_back({*x, *y});
      if (dictionary_.cells.size() > max_data_cells) {
        return "more than " + std::to_string(max_data_cells) + " data cells";
      }
    }
    return std::nullopt;
  }

  Problem read_symmetric(std::string_view rest) {
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest)) {
      const auto id = number<std::size_t>(word);
      if (!id || *id >= max_codes) return quoted(word) + " is not an id";
      symmetric_.push_back(*id);
    }
    return std::nullopt;
  }

  Problem read_code(std::string_view word, std::string_view rest) {
    if (code_lines_.empty()) {
      if (auto problem = settle_cells()) return problem;
    }
    std::string_view digits = word;
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    const auto code = number<std::uint64_t>(digits, 16);
    const std::size_t bits = dictionary_.cells.size();
    if (!code) return quoted(word) + " is not a code of up to 16 hexadecimal digits";
    if (bits < 64 && *code >> bits != 0) {
      return "code " + quoted(word) + " has more than " + std::to_string(bits) + " bits";
    }
    if (const auto more = take_word(rest); !more.empty()) return quoted(more) + " after the code";
    if (code_lines_.size() == max_codes) return "more than " + std::to_string(max_codes) + " codes";
    dictionary_.codes.push_back(*code);
    code_lines_.push_back(line_);
    return std::nullopt;
  }

  /// Before the first code: the width and the data cells.
  Problem settle_cells() {
    const int ring = dictionary_.border == Border::included ? 0 : 1;
    dictionary_.width = per_side_ + 2 * ring;
    if (cells_line_ == 0) {
      if (per_side_ > 8) return "more than 8 cells per side need a list of 'cells'";
      for (int y = 0; y < per_side_; ++y) {
        for (int x = 0; x < per_side_; ++x) {
          dictionary_.cells.push_back(
              {static_cast<std::int8_t>(x + ring), static_cast<std::int8_t>(y + ring)});
        }
      }
    }
    return check_cells(dictionary_);
  }

  /// After the last line: what concerns several codes. The messages carry their own lines.
  Problem finish() {
    if (per_side_ == 0) return dictionary_.name + ": no first line with cells per side and corrected bits";
    if (code_lines_.empty()) return dictionary_.name + ": no codes";
    for (const std::size_t id : symmetric_) {
      if (id >= code_lines_.size()) {
        return dictionary_.name + ": 'symmetric' names id " + std::to_string(id) + ", but there are " +
               std::to_string(code_lines_.size()) + " codes";
      }
    }
    const CellRotation rotation(dictionary_.cells, dictionary_.width);
    for (std::size_t id = 0; id < code_lines_.size(); ++id) {
      const bool stated = std::ranges::find(symmetric_, id) != symmetric_.end();
      if (rotation.is_own(dictionary_.codes[id]) != stated) {
        return at_line(
            code_lines_[id],
            "code of id " + std::to_string(id) +
                (stated ? " is stated as symmetric but is not"
                        : " looks the same turned, so its corners cannot be told apart; if it must "
                          "stay, add a line 'symmetric " +
                              std::to_string(id) + "'"));
      }
    }
    if (const auto twice = equal_codes(dictionary_)) {
      return at_line(code_lines_[twice->second], "ids " + std::to_string(twice->first) + " and " +
                                                     std::to_string(twice->second) +
                                                     " have the same code (in some rotation)");
    }
    if (!stated_distance_ && dictionary_.codes.size() > most_codes_compared) {
      return dictionary_.name + ": more than " + std::to_string(most_codes_compared) +
             " codes need a line 'distance'";
    }
    dictionary_.distance = stated_distance_ ? *stated_distance_ : least_distance(dictionary_);
    if (auto problem = check_corrected_bits(dictionary_)) return dictionary_.name + ": " + *problem;
    return std::nullopt;
  }

  Dictionary dictionary_;
  int line_ = 0;
  int per_side_ = 0;
  int border_line_ = 0;
  int cells_line_ = 0;
  std::optional<int> stated_distance_;
  std::vector<std::size_t> symmetric_;
  std::vector<int> code_lines_;
};

}  // namespace

Result<Dictionary> parse_codes(std::string_view text, std::string name) {
  return CodesParser(std::move(name)).parse(text);
}

}  // namespace runmark
