#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "marker_scene.h"
#include "pipeline/found_markers.h"
#include "pipeline/hardware_pipeline.h"
#include "pipeline/paper_pipeline.h"
#include "top_bench.h"
#include "top_settings.h"

namespace runmark::rtl {

/// The same cells, but nearly every quad is taken for a marker.
inline Dictionary made_lax(Dictionary dictionary) {
  dictionary.codes = {0};
  dictionary.distance = 64;
  dictionary.corrected_bits = 30;
  return dictionary;
}

/// What becomes of a frame: its markers, and what is said at its end.
struct FrameOutcome {
  std::vector<Marker> markers;
  runmark_record end{};
};

inline constexpr std::size_t most_markers = 100000;

/// The pipeline of these options in C++ with the hardware's number of records.
class Reference {
 public:
  Reference(const Options& options, const Dictionary& dictionary, std::size_t records)
      : dictionaries_{dictionary}, found_(most_markers) {
    if (options.pipeline == Pipeline::hardware) {
      pipeline_ = std::make_unique<HardwarePipeline>(options, dictionaries_, records);
    } else {
      pipeline_ = std::make_unique<PaperPipeline>(options, dictionaries_, records);
    }
  }

  FrameOutcome run(const Scene& scene) {
    found_.begin_frame({0, 0});
    pipeline_->begin_frame(scene.width, scene.height);
    stats_ = {};
    std::vector<const std::uint8_t*> rows;
    for (int y = 0; y < scene.height; ++y) {
      rows.push_back(scene.grey.data() + static_cast<std::ptrdiff_t>(y) * scene.width);
      pipeline_->push_row({rows.data(), scene.width, y + 1, 1, PixelFormat::grey}, found_, stats_);
    }
    pipeline_->end_frame(stats_);
    FrameOutcome outcome{{found_.all().begin(), found_.all().end()}, {}};
    outcome.end.record_peak = static_cast<std::uint16_t>(stats_.records_peak);
    outcome.end.dropped = stats_.dropped_chains != 0 ? 1 : 0;
    return outcome;
  }
  [[nodiscard]] const FrameStats& stats() const { return stats_; }

 private:
  std::vector<Dictionary> dictionaries_;
  std::unique_ptr<FramePipeline> pipeline_;
  FoundMarkers found_;
  FrameStats stats_;
};

/// Takes records until a frame ends, no marker twice.
class FrameCollector {
 public:
  FrameCollector() : found_(most_markers) { found_.begin_frame({0, 0}); }

  std::optional<FrameOutcome> add(const runmark_record& record, int height, bool filtered) {
    if (record.end_of_frame != 0) {
      FrameOutcome outcome{{found_.all().begin(), found_.all().end()}, record};
      found_.begin_frame({0, 0});
      return outcome;
    }
    Marker marker = marker_of(record);
    // The row that had come in when the chain closed: C++ thresholds the hardware profile's a band of tiles
    // at a time, when the band below is in.
    marker.row = record.bottom + (filtered ? 1 : 0);
    if (record.fine != 0)
      marker.row = marker.row / IntegerTiles::side * IntegerTiles::side + 2 * IntegerTiles::side - 1;
    marker.row = std::min(marker.row, height - 1);
    if (!found_.has(marker.corners)) (void)found_.add(marker);
    return {};
  }

 private:
  FoundMarkers found_;
};

inline std::vector<VideoBeat> video_of(const Scene& scene, bool rgb = false) {
  std::vector<VideoBeat> beats;
  beats.reserve(scene.grey.size());
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const std::uint32_t grey = scene.grey[static_cast<std::size_t>(y * scene.width + x)];
      beats.push_back({rgb ? grey * 0x010101U : grey, x == 0 && y == 0, x == scene.width - 1});
    }
  }
  return beats;
}

/// What differs between hardware and C++, or nothing.
inline std::string difference(const FrameOutcome& hardware, const FrameOutcome& plain) {
  const auto differ = [](const std::string& what, double one, double other) {
    return what + ' ' + std::to_string(one) + ", plain " + std::to_string(other);
  };
  for (std::size_t i = 0; i < std::min(hardware.markers.size(), plain.markers.size()); ++i) {
    const Marker& a = hardware.markers[i];
    const Marker& b = plain.markers[i];
    const std::string name = "marker " + std::to_string(i) + ' ';
    if (a.id != b.id) return differ(name + "id", a.id, b.id);
    if (a.hamming != b.hamming) return differ(name + "hamming", a.hamming, b.hamming);
    if (a.margin != b.margin) return differ(name + "margin", a.margin, b.margin);
    if (a.inverted != b.inverted) return differ(name + "inverted", a.inverted, b.inverted);
    if (a.row != b.row) return differ(name + "row", a.row, b.row);
    for (std::size_t k = 0; k < 4; ++k) {
      if (a.corners[k].x != b.corners[k].x) return differ(name + "x", a.corners[k].x, b.corners[k].x);
      if (a.corners[k].y != b.corners[k].y) return differ(name + "y", a.corners[k].y, b.corners[k].y);
    }
  }
  if (hardware.markers.size() != plain.markers.size()) {
    return differ("markers", static_cast<double>(hardware.markers.size()),
                  static_cast<double>(plain.markers.size()));
  }
  if (hardware.end.record_peak != plain.end.record_peak)
    return differ("record peak", hardware.end.record_peak, plain.end.record_peak);
  if (hardware.end.dropped != plain.end.dropped)
    return differ("dropped", hardware.end.dropped, plain.end.dropped);
  return {};
}

}  // namespace runmark::rtl
