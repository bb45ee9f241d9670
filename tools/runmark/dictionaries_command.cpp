#include "dictionaries_command.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>

#include "dictionary/code_distance.h"
#include "errors.h"
#include "output_file.h"
#include "pattern/code_lookup.h"

namespace runmark::cli {

namespace {

using Row = std::vector<std::string>;

std::string_view border_name(Border border) {
  switch (border) {
    case Border::black:
      return "black";
    case Border::reversed:
      return "reversed";
    case Border::included:
      return "included";
  }
  return "";
}

double share(const Dictionary& d) { return accepted_share(d.cells.size(), d.codes.size(), d.corrected_bits); }

std::size_t lookup_bytes(const Dictionary& d) { return CodeLookup(d, d.corrected_bits).memory(); }

/// 1234567 as 1,234,567.
std::string grouped(double number) {
  std::string digits = std::to_string(std::llround(number));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

/// Two digits are enough: 1 in 43,217 as 1 in 43,000; above 10^9 the power of ten.
std::string one_in(double share) {
  const double number = 1 / share;
  if (number >= 1e9) return "1 in 10^" + grouped(std::floor(std::log10(number)));
  const double step = std::pow(10, std::max(0.0, std::floor(std::log10(number)) - 1));
  return "1 in " + grouped(std::round(number / step) * step);
}

const Row head{"name", "codes", "cells", "border", "bits", "distance", "corrected", "accepted", "look-up kB"};

Row row_of(const Dictionary& d) {
  const std::string side = std::to_string(d.width);
  return {d.name,
          grouped(static_cast<double>(d.codes.size())),
          side + "x" + side,
          std::string(border_name(d.border)),
          std::to_string(d.cells.size()),
          std::to_string(d.distance),
          std::to_string(d.corrected_bits),
          one_in(share(d)),
          grouped(static_cast<double>(lookup_bytes(d)) / 1024)};
}

bool is_text(std::size_t column) { return head[column] == "name" || head[column] == "border"; }

/// Columns as wide as their widest entry: words to the left, numbers to the right.
std::string aligned(const std::vector<Row>& rows, std::string_view start, std::string_view between,
                    std::string_view end) {
  std::vector<std::size_t> widths(head.size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line(start);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - row[i].size(), row[i].starts_with('-') ? '-' : ' ');
      if (i > 0) line += between;
      line += is_text(i) ? row[i] + space : space + row[i];
    }
    text += line;
    text += end;
    text += '\n';
  }
  return text;
}

std::string as_json(const std::vector<Dictionary>& dictionaries) {
  auto list = nlohmann::ordered_json::array();
  for (const Dictionary& d : dictionaries) {
    list.push_back({{"name", d.name},
                    {"codes", d.codes.size()},
                    {"width", d.width},
                    {"border", border_name(d.border)},
                    {"bits", d.cells.size()},
                    {"distance", d.distance},
                    {"corrected_bits", d.corrected_bits},
                    {"accepted_share", share(d)},
                    {"lookup_bytes", lookup_bytes(d)}});
  }
  return list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string dictionary_table(const std::vector<Dictionary>& dictionaries, const std::string& format) {
  if (format == "json") return as_json(dictionaries);
  std::vector<Row> rows{head};
  const bool markdown = format == "markdown";
  if (markdown) {
    for (std::size_t i = 0; i < head.size(); ++i)
      rows.resize(2), rows[1].push_back(is_text(i) ? "---" : "--:");
  }
  for (const Dictionary& d : dictionaries) rows.push_back(row_of(d));
  return markdown ? aligned(rows, "| ", " | ", " |") : aligned(rows, "", "  ", "");
}

void add_dictionaries_command(CLI::App& app) {
  struct Settings {
    std::vector<std::string> names;
    std::string format = "text";
    std::string output;
  };
  CLI::App* command = app.add_subcommand("dictionaries", "List the dictionaries and what they hold");
  const auto settings = std::make_shared<Settings>();
  command->add_option("NAME", settings->names, "Dictionaries or .codes files; without any: all built-in ones")
      ->type_name("");
  command->add_option("-f,--format", settings->format, "How they are printed (text)")
      ->check(CLI::IsMember({"text", "json", "markdown"}).description(""))
      ->type_name("text|json|markdown");
  command->add_option("-o,--output", settings->output, "Print into this file instead of standard output")
      ->type_name("FILE");
  command->footer(
      "cells      along the sides of the square that is detected, its border included\n"
      "bits       data cells\n"
      "distance   least number of bits in which two codes differ, in any rotation\n"
      "corrected  wrong bits that are corrected by default\n"
      "accepted   share of random readings that would be taken for a marker\n"
      "look-up    memory for finding codes");
  command->callback([settings] {
    std::vector<std::string> names = settings->names;
    if (names.empty()) names.assign(dictionary_names().begin(), dictionary_names().end());
    std::vector<Dictionary> dictionaries;
    dictionaries.reserve(names.size());
    for (const std::string& name : names) dictionaries.push_back(value_or_throw(load_dictionary(name)));
    OutputFile output(settings->output);
    output.write(dictionary_table(dictionaries, settings->format));
    output.close();
  });
}

}  // namespace runmark::cli
