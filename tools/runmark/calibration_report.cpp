#include "calibration_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "coverage.h"

namespace runmark::cli {
namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 512> buffer{};
  std::va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
  va_end(arguments);
  return buffer.data();
}

const char* name_of(Lens lens) {
  return lens == Lens::plain ? "plain" : lens == Lens::rational ? "rational" : "fisheye";
}

constexpr std::array polynomial_names{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
constexpr std::array fisheye_names{"k1", "k2", "k3", "k4"};

struct Parameter {
  std::string name;
  double value;
  double deviation;  // 0: not known, or held
};

std::vector<Parameter> parameters_of(const Calibration& c) {
  const Camera& camera = c.camera;
  const auto deviation = [&](std::size_t i) { return i < c.deviations.size() ? c.deviations[i] : 0; };
  std::vector<Parameter> parameters{{"fx", camera.fx, deviation(0)},
                                    {"fy", camera.fy, deviation(1)},
                                    {"cx", camera.cx, deviation(2)},
                                    {"cy", camera.cy, deviation(3)}};
  const std::size_t count =
      camera.lens == Lens::rational ? 8 : static_cast<std::size_t>(coefficients_of(camera.lens));
  for (std::size_t i = 0; i < count; ++i) {
    const char* name = camera.lens == Lens::fisheye ? fisheye_names[i] : polynomial_names[i];
    parameters.push_back({name, camera.distortion[i], deviation(4 + i)});
  }
  return parameters;
}

std::size_t left_out(const CalibratedView& view) {
  return static_cast<std::size_t>(std::count(view.used.begin(), view.used.end(), false));
}

std::string remark(const CalibratedView& view) {
  if (view.outlier) return "left out: disagrees with the others";
  const std::size_t corners = left_out(view);
  if (corners == 0) return "";
  return std::to_string(corners) + (corners == 1 ? " corner left out" : " corners left out");
}

struct Totals {
  std::size_t views = 0;
  std::size_t corners = 0;
};

Totals totals_of(const Calibration& calibration) {
  Totals totals;
  for (const CalibratedView& view : calibration.views) {
    if (view.outlier) continue;
    ++totals.views;
    totals.corners += view.used.size() - left_out(view);
  }
  return totals;
}

std::string coverage_line(const std::vector<CalibrationView>& views, const Calibration& calibration) {
  const Coverage coverage(views, calibration);
  std::string text = format("corners in %d of %d parts of the picture", coverage.parts_reached(),
                            Coverage::columns * Coverage::rows);
  const auto empty = coverage.empty_regions();
  for (std::size_t i = 0; i < empty.size(); ++i) text += (i == 0 ? "; none: " : ", ") + std::string(empty[i]);
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string colour(std::size_t view) { return format("hsl(%zu,75%%,42%%)", view * 137 % 360); }

/// Offsets of all corners round (0, 0); those left out are hollow.
std::string offsets_plot(const Calibration& calibration) {
  const double reach = std::max(0.1, 5 * calibration.error);
  std::string svg = format(
      "<svg viewBox='-160 -160 320 320' width='420'><rect x='-150' y='-150' width='300' height='300'/>");
  for (const double share : {0.5, 1.0}) {
    svg += format("<circle class='grid' r='%.1f'/><text x='4' y='%.1f'>%.2g px</text>", 150 * share,
                  -150 * share + 11, reach * share);
  }
  svg += "<path class='grid' d='M-150 0H150M0-150V150'/>";
  for (std::size_t i = 0; i < calibration.views.size(); ++i) {
    const CalibratedView& view = calibration.views[i];
    for (std::size_t k = 0; k < view.offsets.size(); ++k) {
      const bool used = view.used[k] && !view.outlier;
      const double x = std::clamp(view.offsets[k].x / reach, -1.0, 1.0) * 150;
      const double y = std::clamp(view.offsets[k].y / reach, -1.0, 1.0) * 150;
      svg += format("<circle cx='%.1f' cy='%.1f' r='1.6' %s='%s'/>", x, y,
                    used ? "fill" : "fill='none' stroke", colour(i).c_str());
    }
  }
  return svg + "</svg>";
}

/// Each corner where it lies in the picture, and its offset made longer.
std::string places_plot(const std::vector<CalibrationView>& views, const Calibration& calibration,
                        double longer) {
  const Camera& camera = calibration.camera;
  const double unit = camera.width / 640.0;
  std::string svg =
      format("<svg viewBox='-0.5 -0.5 %d %d' width='640'><rect x='-0.5' y='-0.5' width='%d' height='%d'/>",
             camera.width, camera.height, camera.width, camera.height);
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t k = 0; k < views[i].image.size(); ++k) {
      const Point p = views[i].image[k];
      if (longer == 0) {
        svg +=
            format("<circle cx='%.1f' cy='%.1f' r='%.1f' fill='%s'/>", p.x, p.y, 2 * unit, colour(i).c_str());
        continue;
      }
      const Point o = calibration.views[i].offsets[k];
      if (std::hypot(o.x, o.y) * longer > 0.5 * camera.width) continue;
      svg += format("<path d='M%.1f %.1fl%.1f %.1f' stroke='%s' stroke-width='%.1f'/>", p.x, p.y,
                    longer * o.x, longer * o.y, colour(i).c_str(), unit);
    }
  }
  return svg + "</svg>";
}

std::string views_table(const std::vector<CalibrationView>& views, const Calibration& calibration) {
  double most = 1e-9;
  for (const CalibratedView& view : calibration.views) most = std::max(most, view.error);
  std::string table = "<table><tr><th>view</th><th>corners</th><th>error, px</th><th></th><th></th></tr>";
  for (std::size_t i = 0; i < views.size(); ++i) {
    const CalibratedView& view = calibration.views[i];
    table += "<tr><td>" + escaped(views[i].name) +
             format(
                 "</td><td>%zu</td><td>%.3f</td><td><svg width='160' height='10'><path d='M0 0h%.1fv10H0z' "
                 "fill='%s'/></svg></td><td>",
                 views[i].object.size(), view.error, 160 * view.error / most, colour(i).c_str()) +
             remark(view) + "</td></tr>";
  }
  return table + "</table>";
}

}  // namespace

std::string calibration_text(const std::vector<CalibrationView>& views, const Calibration& calibration) {
  const Camera& camera = calibration.camera;
  const Totals totals = totals_of(calibration);
  std::string text =
      format("%d x %d, %s lens: %zu views, %zu corners, error %.3f px\n", camera.width, camera.height,
             name_of(camera.lens), totals.views, totals.corners, calibration.error);
  for (const Parameter& p : parameters_of(calibration)) {
    text += format("  %-3s %14.6g", p.name.c_str(), p.value);
    text += p.deviation > 0 ? format(" +- %.2g\n", p.deviation) : std::string("\n");
  }
  std::size_t width = 4;
  for (const CalibrationView& view : views) width = std::max(width, view.name.size());
  text += "  view" + std::string(width - 4, ' ') + "  corners  error, px\n";
  for (std::size_t i = 0; i < views.size(); ++i) {
    const CalibratedView& view = calibration.views[i];
    text += "  " + views[i].name + std::string(width - views[i].name.size(), ' ') +
            format("  %7zu  %9.3f", views[i].object.size(), view.error);
    const std::string note = remark(view);
    text += note.empty() ? "\n" : "  " + note + "\n";
  }
  return text + "  " + coverage_line(views, calibration) + "\n";
}

std::string calibration_page(const std::vector<CalibrationView>& views, const Calibration& calibration) {
  const Camera& camera = calibration.camera;
  const Totals totals = totals_of(calibration);
  std::string rows;
  for (const Parameter& p : parameters_of(calibration)) {
    rows += format("<tr><td>%s</td><td>%.6g</td><td>%s</td></tr>", p.name.c_str(), p.value,
                   p.deviation > 0 ? format("%.2g", p.deviation).c_str() : "");
  }
  const double longer = std::max(1.0, std::round(0.03 * camera.width / std::max(calibration.error, 1e-3)));
  return "<!doctype html><html lang='en'><meta charset='utf-8'><title>Camera calibration</title><style>"
         "body{font:15px sans-serif;max-width:70em;margin:2em auto;padding:0 1em}"
         "table{border-collapse:collapse}td,th{padding:.2em .8em;text-align:left;border-bottom:1px solid "
         "#ddd}"
         "svg{vertical-align:middle}rect{fill:#fff;stroke:#bbb;stroke-width:1;vector-effect:non-scaling-"
         "stroke}"
         ".grid{fill:none;stroke:#ddd}text{font-size:10px;fill:#777}figure{display:inline-block;margin:1em "
         "1em 1em 0}"
         "</style><h1>Camera calibration</h1><p>" +
         format("%d x %d pixels, %s lens. %zu views, %zu corners, rms error <b>%.3f px</b>. ", camera.width,
                camera.height, name_of(camera.lens), totals.views, totals.corners, calibration.error) +
         coverage_line(views, calibration) +
         ".</p><table><tr><th></th><th>value</th><th>deviation</th></tr>" + rows + "</table><figure>" +
         places_plot(views, calibration, 0) +
         "<figcaption>Where the corners lie in the picture, a colour for each "
         "view.</figcaption></figure><figure>" +
         offsets_plot(calibration) +
         "<figcaption>Corners seen less corners projected. What was left out is "
         "hollow.</figcaption></figure><figure>" +
         places_plot(views, calibration, longer) +
         format(
             "<figcaption>The same where they lie, %g times as long: a pattern shows what the lens model "
             "cannot "
             "follow.</figcaption></figure><h2>Views</h2>",
             longer) +
         views_table(views, calibration) + "</html>\n";
}

}  // namespace runmark::cli
