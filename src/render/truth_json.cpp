#include "render/truth_json.h"

#include <algorithm>
#include <cmath>

namespace runmark::render {

namespace {

using nlohmann::ordered_json;

// Enough digits for the eye and for errors of a thousandth of a pixel, and no tail of nines.
double rounded(double x, double steps) { return std::round(x * steps) / steps; }

ordered_json to_json(const MarkerTruth& m, const FrameTruth& frame) {
  ordered_json corners = ordered_json::array();
  for (const Point p : m.corners) corners.push_back({rounded(p.x, 1e4), rounded(p.y, 1e4)});
  ordered_json j = {{"id", m.id},
                    {"corners", corners},
                    {"side", rounded(m.side, 100)},
                    {"truth", "rendered"},
                    {"size", rounded(m.size, 100)},
                    {"cell", rounded(m.cell, 100)},
                    {"tilt", rounded(m.tilt, 10)},
                    {"distance", rounded(m.distance, 10)},
                    {"margin", rounded(m.margin, 100)},
                    {"blur", rounded(frame.blur, 100)},
                    {"motion", rounded(frame.motion, 100)},
                    {"noise", rounded(frame.noise, 100)},
                    {"contrast", rounded(m.contrast, 10)},
                    {"occluded", m.optional()}};
  if (m.optional()) j["reason"] = m.occluded ? "covered" : "cut";
  return j;
}

}  // namespace

ordered_json to_json(const FrameTruth& truth, const std::string& image) {
  ordered_json markers = ordered_json::array();
  ordered_json maybe = ordered_json::array();
  std::vector<int> ids;
  for (const MarkerTruth& m : truth.markers) {
    (m.optional() ? maybe : markers).push_back(to_json(m, truth));
    ids.push_back(m.id);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return {{"image", image},
          {"width", truth.width},
          {"height", truth.height},
          {"dictionary", truth.dictionary},
          {"inverted", truth.inverted},
          {"markers", markers},
          {"maybe", maybe},
          {"present_ids", ids},
          {"rendered", true},
          {"source", "runmark render"},
          {"scene",
           {{"background", truth.background},
            {"blur", rounded(truth.blur, 100)},
            {"defocus", truth.defocus},
            {"motion", rounded(truth.motion, 100)},
            {"noise", rounded(truth.noise, 100)},
            {"gamma", truth.gamma},
            {"jpeg", truth.jpeg},
            {"distortion", rounded(truth.distortion, 1e4)},
            {"level", rounded(truth.level, 1000)},
            {"gradient", rounded(truth.gradient, 1000)},
            {"vignette", rounded(truth.vignette, 1000)},
            {"shadows", truth.shadows},
            {"lamps", truth.lamps}}}};
}

std::string truth_file(const std::vector<ordered_json>& entries) {
  std::string text = "[\n";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    text += entries[i].dump() + (i + 1 < entries.size() ? ",\n" : "\n");
  }
  return text + "]\n";
}

}  // namespace runmark::render
