#include "bench/side_by_side/svg_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace runmark::bench {
namespace {

constexpr double left = 56;
constexpr double top = 34;
constexpr double plot_width = 700;
constexpr double plot_height = 220;

template <class... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 500> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

// 1, 2 or 5 times a power of ten, so that about five lines fit.
double grid_step(double highest) {
  const double power = std::pow(10, std::floor(std::log10(highest / 5)));
  const double ratio = highest / 5 / power;
  return power * (ratio <= 1 ? 1 : ratio <= 2 ? 2 : ratio <= 5 ? 5 : 10);
}

double highest_value(const Chart& chart) {
  double highest = chart.least_top;
  for (const Series& series : chart.series) {
    for (const auto& value : series.values) highest = std::max(highest, value.value_or(0));
  }
  return highest > 0 ? highest : 1;
}

}  // namespace

std::string series_colour(std::size_t number) {
  constexpr std::array colours{"#d1495b", "#30638e", "#7fb3d5", "#3c7a57", "#a3c9a8", "#8d6a9f"};
  return colours[number % colours.size()];
}

std::string escape_html(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string draw(const Chart& chart) {
  const double highest = highest_value(chart);
  const double step = grid_step(highest);
  const auto y_of = [&](double value) { return top + plot_height * (1 - value / highest); };
  std::string svg = print("<svg viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" role=\"img\" font-size=\"11\">",
                          left + plot_width + 10, top + plot_height + 40, left + plot_width + 10);
  svg += print("<text x=\"%.0f\" y=\"16\" font-size=\"14\" font-weight=\"bold\">", left) +
         escape_html(chart.title) + "</text>";
  for (int i = 0; i * step <= highest * 1.0001; ++i) {
    const double y = y_of(i * step);
    svg += print("<path d=\"M%.0f %.1fh%.0f\" stroke=\"#ddd\"/>", left, y, plot_width);
    svg += print("<text x=\"%.0f\" y=\"%.1f\" text-anchor=\"end\">%g</text>", left - 5, y + 4, i * step);
  }
  svg += print("<text x=\"4\" y=\"%.0f\">", top - 8) + escape_html(chart.unit) + "</text>";
  const double group_width = plot_width / static_cast<double>(std::max<std::size_t>(1, chart.groups.size()));
  const double bar = 0.8 * group_width / static_cast<double>(std::max<std::size_t>(1, chart.series.size()));
  for (std::size_t g = 0; g < chart.groups.size(); ++g) {
    const double x0 = left + group_width * (static_cast<double>(g) + 0.1);
    for (std::size_t s = 0; s < chart.series.size(); ++s) {
      const auto value = chart.series[s].values[g];
      if (!value) continue;
      const double y = y_of(*value);
      svg += print("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"><title>",
                   x0 + bar * static_cast<double>(s), y, bar * 0.92, top + plot_height - y,
                   series_colour(s).c_str()) +
             escape_html(chart.series[s].name + ", " + chart.groups[g]) +
             print(": %.4g</title></rect>", *value);
    }
    svg += print("<text x=\"%.1f\" y=\"%.0f\" text-anchor=\"middle\">", x0 + 0.4 * group_width,
                 top + plot_height + 16) +
           escape_html(chart.groups[g]) + "</text>";
  }
  return svg + "</svg>";
}

}  // namespace runmark::bench
