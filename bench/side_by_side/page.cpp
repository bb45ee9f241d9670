#include "bench/side_by_side/page.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "bench/side_by_side/shared_markers.h"
#include "bench/side_by_side/svg_chart.h"
#include "bench/side_by_side/thumbnail.h"
#include "evaluate/buckets.h"
#include "evaluate/percentile.h"
#include "evaluate/scores.h"

namespace runmark::bench {
namespace {

constexpr std::size_t shown_misses = 24;
const cv::Scalar red(40, 40, 230);
const cv::Scalar blue(220, 120, 0);

template <class... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 600> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

struct Scored {
  const Run& run;
  Scores scores;
};

std::vector<std::string> bucket_labels() {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < size_buckets.count(); ++i) labels.push_back(size_buckets.label(i));
  return labels;
}

std::string summary_table(const std::vector<Scored>& all, const SharedMarkers& shared) {
  std::string html =
      "<table><tr><th>detector<th>recall<th>found<th>false<th>bad corners<th>rotated"
      "<th>corner rms<th>corner rms, shared<th>median ms<th>p95 ms<th>worst ms</tr>";
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Tally& t = all[i].scores.total;
    const auto& ms = all[i].scores.milliseconds;
    html += "<tr><td><span style=\"color:" + series_colour(i) + "\">&#9632;</span> " +
            escape_html(all[i].run.name);
    html += print("<td>%.4f<td>%d/%d<td>%d<td>%d<td>%d<td>%.3f<td>%.3f<td>%.2f<td>%.2f<td>%.2f</tr>\n",
                  t.recall(), t.found, t.truth, t.false_alarms, t.bad_corners, t.rotated, t.corners.rms(),
                  shared.total[i].rms(), percentile(ms, 0.5), percentile(ms, 0.95), percentile(ms, 1));
  }
  return html + "</table>";
}

Chart recall_chart(const std::vector<Scored>& all) {
  Chart chart{"Recall by size of the marker (square root of its area, px)", "recall", bucket_labels(), {}, 1};
  for (const Scored& one : all) {
    Series series{one.run.name, std::vector<std::optional<double>>(size_buckets.count())};
    for (const Breakdown& breakdown : one.scores.breakdowns) {
      if (breakdown.name != "size") continue;
      for (const auto& [label, tally] : breakdown.rows) {
        const auto at = std::ranges::find(chart.groups, label) - chart.groups.begin();
        series.values[static_cast<std::size_t>(at)] = tally.recall();
      }
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart corner_chart(const std::vector<Scored>& all, const SharedMarkers& shared) {
  Chart chart{
      print("Corner error, rms, on the %d markers that all found", shared.count), "px", bucket_labels(), {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    Series series{all[i].run.name, {}};
    for (const CornerErrors& errors : shared.by_size[i]) {
      series.values.push_back(errors.count() == 0 ? std::nullopt : std::optional(errors.rms()));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart time_chart(const std::vector<Scored>& all) {
  Chart chart{"CPU time for an image, one thread", "ms", {"median", "p95"}, {}};
  for (const Scored& one : all) {
    const auto& ms = one.scores.milliseconds;
    chart.series.push_back({one.run.name, {percentile(ms, 0.5), percentile(ms, 0.95)}});
  }
  return chart;
}

// Pictures are read again one by one: a whole set need not fit into memory.
class Gallery {
 public:
  Gallery(const std::vector<TruthImage>& truth, const TruthFolder& folder) {
    for (const TruthImage& image : truth) files_[image.image] = folder.image(image).string();
  }

  std::string figure(const Mistake& mistake, const cv::Scalar& colour) {
    if (mistake.image != name_) {
      name_ = mistake.image;
      grey_ = cv::imread(files_.at(name_), cv::IMREAD_GRAYSCALE);
    }
    const std::string uri = grey_.empty() ? "" : thumbnail(grey_, mistake.corners, colour);
    return "<figure>" + (uri.empty() ? "" : "<img alt=\"\" src=\"" + uri + "\">") + "<figcaption>" +
           print("id %d, %.0f px, ", mistake.id, marker_size(mistake.corners)) +
           std::string(name_of(mistake.kind)) + "<br>" + escape_html(mistake.image) +
           "</figcaption></figure>";
  }

 private:
  std::map<std::string, std::string> files_;
  std::string name_;
  cv::Mat grey_;
};

std::string mistakes_section(const Scored& one, Gallery& gallery) {
  std::vector<Mistake> misses;
  std::vector<Mistake> alarms;
  for (const Mistake& mistake : one.scores.mistakes) {
    (mistake.kind == Mistake::Kind::false_alarm ? alarms : misses).push_back(mistake);
  }
  std::ranges::stable_sort(misses, std::greater{}, [](const Mistake& m) { return marker_size(m.corners); });
  const std::size_t shown = std::min(misses.size(), shown_misses);
  std::string html = "<h2>" + escape_html(one.run.name) + "</h2>";
  html += print("<h3>Worst misses: the largest %zu of %zu</h3><div>", shown, misses.size());
  for (std::size_t i = 0; i < shown; ++i) html += gallery.figure(misses[i], blue);
  html += print("</div><h3>False alarms: %zu</h3><div>", alarms.size());
  for (const Mistake& alarm : alarms) html += gallery.figure(alarm, red);
  return html + "</div>\n";
}

constexpr const char* style =
    "<style>body{font:14px sans-serif;max-width:1000px;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse}td,th{padding:.25em .7em;text-align:right;border-bottom:1px solid #ddd}"
    "td:first-child,th:first-child{text-align:left}svg{max-width:100%;margin:1em 0}"
    "figure{display:inline-block;margin:4px;width:132px;vertical-align:top}"
    "figcaption{font-size:10px;overflow-wrap:anywhere}</style>";

}  // namespace

std::string comparison_page(const std::string& title, const std::vector<TruthImage>& truth,
                            const TruthFolder& folder, const std::vector<Run>& runs) {
  std::vector<Scored> all;
  for (const Run& run : runs) all.push_back({run, score(truth, run.observations)});
  const SharedMarkers shared = shared_markers(truth, runs);
  std::string html = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>" + escape_html(title) +
                     "</title>" + style + "<h1>" + escape_html(title) + "</h1>";
  html += print(
      "<p>%zu images, %d markers. Every image was shown to each detector in turn, in one thread of one "
      "program; times are CPU time. A marker is found when its id and place are right and no corner is "
      "off by more than 3 px or a tenth of its side.</p>\n",
      truth.size(), all.empty() ? 0 : all.front().scores.total.truth);
  html += summary_table(all, shared) + draw(recall_chart(all)) + draw(corner_chart(all, shared)) +
          draw(time_chart(all)) + "\n";
  Gallery gallery(truth, folder);
  for (const Scored& one : all) html += mistakes_section(one, gallery);
  return html + "</html>\n";
}

}  // namespace runmark::bench
