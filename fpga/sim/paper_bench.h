#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "Vpaper_cores.h"
#include "clocked.h"
#include "marker_scene.h"
#include "pipeline/found_markers.h"
#include "runmark/detector.h"

namespace runmark::rtl {

struct Outcome {
  std::vector<Marker> markers;
  std::uint64_t cycles = 0;
  std::uint64_t latest = 0;  ///< clocks from the input of a marker's last pixel to its report, the longest
  std::uint64_t dropped = 0;
  std::uint64_t quads = 0;
  std::uint64_t record_peak = 0;
  std::uint64_t end_peak = 0;
  bool ended = false;
  bool list_full = false;
  bool grey_differs = false;  ///< a grey level did not come out as it went in
};

/// The translated paper_cores with a memory that keeps the grey levels and answers after a while.
class PaperBench {
 public:
  explicit PaperBench(const Dictionary& dictionary) {
    core_->codes = static_cast<std::uint16_t>(dictionary.codes.size());
    for (std::size_t i = 0; i < dictionary.codes.size(); ++i) {
      core_->code_write = 1;
      drive(core_->code_at, i);
      core_->code = dictionary.codes[i];
      core_.tick();
    }
    core_->code_write = 0;
  }

  /// @param percent_in  how often a pixel is offered
  /// @param latency     clocks from a read of the memory to its answer; 0 also accepts every read at once
  Outcome run(const Scene& scene, const Options& options, int max_errors, int percent_in, int latency) {
    drive(core_->last_x, static_cast<unsigned>(scene.width - 1));
    drive(core_->last_y, static_cast<unsigned>(scene.height - 1));
    drive(core_->level, static_cast<unsigned>(options.fixed_threshold));
    core_->above_is_dark = options.above_is_dark;
    core_->rgb = 0;
    core_->cases = filter_all;
    core_->eight = 1;
    core_->give_up = 0;
    core_->max_turns = 30;
    drive(core_->min_height, static_cast<unsigned>(options.min_marker_size / 2));
    core_->holes = options.inverted;
    core_->patient = 0;
    drive(core_->corner_offset, static_cast<unsigned>(options.corner_offset));
    drive(core_->min_area, static_cast<unsigned>(2 * options.min_marker_size * options.min_marker_size));
    drive(core_->max_area, (1U << 21) - 1);
    drive(core_->max_errors, static_cast<unsigned>(max_errors));

    Willing sends(percent_in, 51);
    Willing answers(latency == 0 ? 100 : 50, 52);
    struct Answer {
      std::uint8_t level;
      std::uint64_t due;
    };
    std::deque<Answer> due;
    Outcome result;
    FoundMarkers found(1000);
    found.begin_frame({0, 0});
    const std::uint64_t begin = core_.cycles();
    const int all = scene.width * scene.height;
    std::vector<std::uint64_t> pixel_at(scene.grey.size());
    int at = 0;
    int grey_at = 0;
    bool offered = false;
    while (core_.cycles() - begin < static_cast<std::uint64_t>(all) * 10 && !result.ended) {
      offered = offered || (at < all && sends());
      core_->in_valid = offered;
      core_->in_sof = at == 0;
      core_->in_data = at < all ? scene.grey[static_cast<std::size_t>(at)] : 0;
      core_->grey_ready = 1;
      // A row can be read once all of it has come out.
      core_.settle();
      core_->read_ready =
          core_->read_valid && (static_cast<int>(core_->read_y) + 1) * scene.width <= grey_at && answers();
      core_->answer_valid = !due.empty() && due.front().due <= core_.cycles();
      if (core_->answer_valid) core_->answer = due.front().level;
      core_->marker_ready = answers();
      core_.settle();
      if (core_->answer_valid) due.pop_front();
      if (core_->in_valid && core_->in_ready) {
        pixel_at[static_cast<std::size_t>(at)] = core_.cycles();
        offered = false;
        ++at;
      }
      if (core_->grey_valid) {
        result.grey_differs |= core_->grey_level != scene.grey[static_cast<std::size_t>(grey_at++)];
      }
      if (core_->read_valid && core_->read_ready) {
        const std::size_t place =
            static_cast<std::size_t>(core_->read_y) * static_cast<std::size_t>(scene.width) + core_->read_x;
        due.push_back({scene.grey[place], core_.cycles() + 1 + static_cast<std::uint64_t>(latency)});
      }
      result.dropped += (core_->count_dropped_full | core_->count_dropped_queue | core_->lost) != 0 ? 1U : 0U;
      result.quads += core_->count_quad;
      if (core_->marker_valid && core_->marker_ready) {
        if (core_->marker_end) {
          result.ended = true;
        } else {
          add(found, pixel_at, scene.width, result);
        }
      }
      core_.tick();
    }
    result.cycles = core_.cycles() - begin;
    result.record_peak = core_->record_peak;
    result.end_peak = core_->end_peak;
    result.markers.assign(found.all().begin(), found.all().end());
    return result;
  }

 private:
  void add(FoundMarkers& found, const std::vector<std::uint64_t>& pixel_at, int width, Outcome& result) {
    Marker marker;
    marker.id = core_->marker_id;
    marker.hamming = core_->marker_errors;
    marker.inverted = core_->marker_hole != 0;
    for (unsigned i = 0; i < 4; ++i) {
      marker.corners[i] = {static_cast<double>(core_->marker_x >> (10 * i) & 1023) - 0.5,
                           static_cast<double>(core_->marker_y >> (9 * i) & 511) - 0.5};
    }
    double right = 0;
    for (const Point& corner : marker.corners) right = std::max(right, corner.x);
    // The chain closed on this crack line: the last dark row is the one above.
    const std::size_t row_end =
        static_cast<std::size_t>(core_->marker_bottom) * static_cast<std::size_t>(width);
    const std::size_t last = row_end - static_cast<std::size_t>(width) + static_cast<std::size_t>(right);
    result.latest = std::max(result.latest, core_.cycles() - pixel_at[last]);
    if (found.has(marker.corners)) return;
    result.list_full |= !found.add(marker);
  }
  Clocked<Vpaper_cores> core_;
};

}  // namespace runmark::rtl
