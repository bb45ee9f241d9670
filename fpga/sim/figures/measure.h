#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cores_bench.h"
#include "event_counts.h"
#include "runmark/detector.h"

namespace runmark::rtl {

inline bool same_marker(const Marker& a, const Marker& b) {
  const auto same = [](Point p, Point q) { return p.x == q.x && p.y == q.y; };
  return a.id == b.id && std::equal(a.corners.begin(), a.corners.end(), b.corners.begin(), same);
}

inline constexpr int memory_latency = 30;

/// A VGA frame through the hardware, with the records it has, and through the plain pipeline, with 65,535.
template <class Cores>
class Measure {
 public:
  explicit Measure(const Dictionary& dictionary)
      : options_(options_of(Cores::pipeline, 640, 480)),
        bench_(dictionary),
        detector_(Detector::create(options_, {dictionary})) {}

  nlohmann::json operator()(const Scene& scene, const std::string& name) {
    const Detection plain =
        detector_->detect(ImageView::grey(scene.grey.data(), scene.width, scene.height, scene.width));
    const FrameStats& stats = detector_->stats();
    // Twice without a pause: the second frame shows how soon the cores are ready for it.
    const CoresOutcome hardware = bench_.run(scene, options_, 100, memory_latency, 2);
    const EventCounts events = count_events(dark_rows(scene, options_), scene.width, Cores::rules(options_));
    std::size_t missed = 0;
    for (const Marker& marker : plain) {
      const auto same = [&](const Marker& other) { return same_marker(marker, other); };
      missed += std::none_of(hardware.markers.begin(), hardware.markers.end(), same) ? 1U : 0U;
    }
    const auto pixels = static_cast<std::uint64_t>(scene.grey.size());
    return {
        {"name", name},
        {"pixels", pixels},
        {"width", scene.width},
        {"runs", events.runs()},
        {"segments", events.starts},
        {"events", events.all()},
        {"events_per_100_pixels", 100.0 * static_cast<double>(events.all()) / static_cast<double>(pixels)},
        {"contour_clocks", events.clocks(stats.closed_chains)},
        {"ended", hardware.ended},
        {"cycles", hardware.cycles},
        {"cycles_per_pixel", static_cast<double>(hardware.pace) / static_cast<double>(pixels)},
        {"markers", plain.markers.size()},
        {"missed", missed},
        {"quads", stats.quads},
        {"quads_of_hardware", static_cast<double>(hardware.quads) / 2},
        {"dropped", hardware.dropped},
        {"record_peak", hardware.record_peak},
        {"record_peak_unlimited", stats.records_peak},
        {"end_peak", hardware.end_peak},
        {"latest_report", hardware.latest}};
  }

 private:
  Options options_;
  CoresBench<Cores> bench_;
  Result<Detector> detector_;
};

}  // namespace runmark::rtl
