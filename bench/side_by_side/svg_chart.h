#pragma once

#include <optional>
#include <string>
#include <vector>

namespace runmark::bench {

/// One detector's values in a chart; nothing where there is no value.
struct Series {
  std::string name;
  std::vector<std::optional<double>> values;
};

struct Chart {
  std::string title;
  std::string unit;                 ///< of the values, at the axis
  std::vector<std::string> groups;  ///< along the x axis; as many as each series has values
  std::vector<Series> series;
  double least_top = 0;  ///< the axis goes at least this far
};

/// Bars in groups, as an <svg> element that needs nothing else.
[[nodiscard]] std::string draw(const Chart& chart);

/// The colour of the series of that number.
[[nodiscard]] std::string series_colour(std::size_t number);

[[nodiscard]] std::string escape_html(const std::string& text);

}  // namespace runmark::bench
