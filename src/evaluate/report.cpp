#include "evaluate/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>

#include "evaluate/percentile.h"

namespace runmark {
namespace {

template <class... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

nlohmann::json to_json(const Tally& tally) {
  nlohmann::json object{{"truth", tally.truth},
                        {"found", tally.found},
                        {"recall", tally.recall()},
                        {"bad_corners", tally.bad_corners},
                        {"rotated", tally.rotated},
                        {"false_alarms", tally.false_alarms},
                        {"extra", tally.extra},
                        {"duplicates", tally.duplicates},
                        {"corners", tally.corners.count()}};
  if (tally.corners.count() == 0) return object;
  const Point bias = tally.corners.bias();
  object["corner_rms"] = tally.corners.rms();
  object["corner_median"] = tally.corners.percentile(0.5);
  object["corner_p90"] = tally.corners.percentile(0.9);
  object["corner_p95"] = tally.corners.percentile(0.95);
  object["corner_bias"] = {bias.x, bias.y};
  object["corner_outward_bias"] = tally.corners.outward_bias();
  return object;
}

nlohmann::json to_json(const Mistake& mistake) {
  nlohmann::json corners = nlohmann::json::array();
  for (const Point& p : mistake.corners) corners.push_back({p.x, p.y});
  return {{"kind", name_of(mistake.kind)},
          {"image", mistake.image},
          {"id", mistake.id},
          {"corners", std::move(corners)}};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void write_csv_row(std::ostream& out, const std::string& group, const std::string& bucket, const Tally& t) {
  out << group << ',' << quoted(bucket) << ',' << t.truth << ',' << t.found << ','
      << print("%.4f", t.recall()) << ',' << t.bad_corners << ',' << t.rotated << ',' << t.false_alarms << ','
      << t.extra << ',' << t.duplicates << ',';
  if (t.corners.count() != 0) {
    out << print("%.4f,%.4f,%.4f,%.4f,%.4f,%.4f", t.corners.rms(), t.corners.percentile(0.5),
                 t.corners.percentile(0.95), t.corners.bias().x, t.corners.bias().y,
                 t.corners.outward_bias());
  } else {
    out << ",,,,,";
  }
  out << '\n';
}

}  // namespace

void write_text(std::ostream& out, const Scores& scores) {
  const Tally& t = scores.total;
  out << print("%zu images, %d markers\n", scores.images, t.truth)
      << print("recall %.4f (%d/%d)  false %d  extra %d  bad corner %d  rotated %d  duplicate or maybe %d\n",
               t.recall(), t.found, t.truth, t.false_alarms, t.extra, t.bad_corners, t.rotated, t.duplicates);
  if (t.corners.count() != 0) {
    out << print("corner error, %zu corners: median %.3f  p90 %.3f  p95 %.3f  rms %.3f px\n",
                 t.corners.count(), t.corners.percentile(0.5), t.corners.percentile(0.9),
                 t.corners.percentile(0.95), t.corners.rms())
        << print("corner bias: x %+.3f  y %+.3f  outward %+.3f px\n", t.corners.bias().x, t.corners.bias().y,
                 t.corners.outward_bias());
  }
  if (const auto& ms = scores.milliseconds; !ms.empty()) {
    out << print("time, %zu images: median %.2f  p95 %.2f  worst %.2f ms\n", ms.size(), percentile(ms, 0.5),
                 percentile(ms, 0.95), ms.back());
  }
  for (const Breakdown& breakdown : scores.breakdowns) {
    out << print("\n%-60s %7s %9s %6s %5s %7s %6s\n", breakdown.name.c_str(), "recall", "found", "false",
                 "bad", "rotated", "rms");
    for (const auto& [label, row] : breakdown.rows) {
      const std::string rms = row.corners.count() == 0 ? "" : print("%.3f", row.corners.rms());
      out << print("  %-58s %7s %4d/%-4d %6d %5d %7d %6s\n", label.c_str(),
                   row.truth == 0 ? "" : print("%.3f", row.recall()).c_str(), row.found, row.truth,
                   row.false_alarms, row.bad_corners, row.rotated, rms.c_str());
    }
  }
}

void write_json(std::ostream& out, const Scores& scores) {
  nlohmann::json object;
  object["images"] = scores.images;
  object["total"] = to_json(scores.total);
  for (const Breakdown& breakdown : scores.breakdowns) {
    nlohmann::json& rows = object["by"][breakdown.name] = nlohmann::json::array();
    for (const auto& [label, tally] : breakdown.rows) {
      rows.push_back(to_json(tally));
      rows.back()["bucket"] = label;
    }
  }
  object["mistakes"] = nlohmann::json::array();
  for (const Mistake& mistake : scores.mistakes) object["mistakes"].push_back(to_json(mistake));
  if (const auto& ms = scores.milliseconds; !ms.empty()) {
    object["ms"] = {{"images", ms.size()},
                    {"median", percentile(ms, 0.5)},
                    {"p95", percentile(ms, 0.95)},
                    {"worst", ms.back()}};
  }
  out << object.dump(1) << '\n';
}

void write_csv(std::ostream& out, const Scores& scores) {
  out << "group,bucket,truth,found,recall,bad_corners,rotated,false_alarms,extra,duplicates,"
         "corner_rms,corner_median,corner_p95,bias_x,bias_y,outward_bias\n";
  write_csv_row(out, "total", "", scores.total);
  for (const Breakdown& breakdown : scores.breakdowns) {
    for (const auto& [label, tally] : breakdown.rows) write_csv_row(out, breakdown.name, label, tally);
  }
}

}  // namespace runmark
