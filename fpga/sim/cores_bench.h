#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "Vhardware_cores.h"
#include "Vpaper_cores.h"
#include "clocked.h"
#include "marker_scene.h"
#include "pipeline/found_markers.h"
#include "runmark/detector.h"
#include "signed_port.h"
#include "top_settings.h"

namespace runmark::rtl {

/// The five cores of the paper profile in a row, without buses.
struct PaperCores {
  using Model = Vpaper_cores;
  static constexpr Pipeline pipeline = Pipeline::paper;
  static constexpr std::uint64_t areas = (1U << 21) - 1;  ///< that the core can be told

  static ContourRules rules(const Options& options) { return PaperPipeline::contour_rules(options); }
  static void set(Model& core, const runmark_settings& s) {
    core.level = s.threshold;
    core.above_is_dark = (s.control & RUNMARK_CONTROL_ABOVE_IS_DARK) != 0;
    core.corner_offset = s.corner_offset;
  }
  static void place(const Model& core, runmark_record& record) {
    for (unsigned i = 0; i < 4; ++i) {
      record.x[i] = static_cast<int>(core.marker_x >> (10 * i) & 1023);
      record.y[i] = static_cast<int>(core.marker_y >> (9 * i) & 511);
    }
  }
};

/// Those of the hardware profile.
struct HardwareCores {
  using Model = Vhardware_cores;
  static constexpr Pipeline pipeline = Pipeline::hardware;
  static constexpr std::uint64_t areas = (1U << 20) - 1;

  static ContourRules rules(const Options& options) { return HardwarePipeline::contour_rules(options); }
  static void set(Model& core, const runmark_settings& s) {
    core.min_contrast = s.min_contrast;
    core.min_side = s.min_side;
    core.width = s.cells;
    core.min_margin = s.min_margin;
  }
  static void place(const Model& core, runmark_record& record) {
    constexpr unsigned bits = 16;
    record.fine = 1;
    record.clearance = core.marker_clearance;
    record.scale = core.marker_scale;
    for (unsigned i = 0; i < 4; ++i) {
      record.x[i] = signed_part(core.marker_x, i, bits);
      record.y[i] = signed_part(core.marker_y, i, bits);
    }
  }
};

struct CoresOutcome {
  std::vector<Marker> markers;
  std::uint64_t cycles = 0;   ///< from the first pixel to the end of the (first) frame's results
  std::uint64_t pace = 0;     ///< from the first pixel to the next frame's
  std::uint64_t latest = 0;   ///< clocks from the input of a marker's last pixel to its report, the longest
  std::uint64_t dropped = 0;  ///< clocks in which something was
  std::uint64_t quads = 0;
  std::uint64_t runs = 0;
  std::uint64_t record_peak = 0;
  std::uint64_t end_peak = 0;
  bool ended = false;
  bool list_full = false;
  bool grey_differs = false;  ///< a grey level did not come out as it went in
};

/// The translated cores with a memory that keeps the grey levels and answers after a while.
template <class Cores>
class CoresBench {
 public:
  explicit CoresBench(const Dictionary& dictionary) : dictionary_(dictionary) {
    drive(core_->codes, dictionary.codes.size());
    for (std::size_t i = 0; i < dictionary.codes.size(); ++i) {
      core_->code_write = 1;
      drive(core_->code_at, i);
      core_->code = dictionary.codes[i];
      core_.tick();
    }
    core_->code_write = 0;
  }

  static constexpr int in_threshold = 8;

  /// @param percent_in  how often a pixel is offered
  /// @param latency     clocks from a read of the memory to its answer; 0 also accepts every read at once
  /// @param frames      how often the scene is sent, without a pause; counts are of all of them
  CoresOutcome run(const Scene& scene, Options options, int percent_in, int latency, int frames = 1) {
    options.pipeline = Cores::pipeline;
    set(settings_of(options, dictionary_, scene.width, scene.height, 0));
    Willing sends(percent_in, 51);
    Willing answers(latency == 0 ? 100 : 50, 52);
    struct Answer {
      std::uint8_t level;
      std::uint64_t due;
    };
    std::deque<Answer> due;
    CoresOutcome result;
    FoundMarkers found(1000);
    found.begin_frame({0, 0});
    const std::uint64_t begin = core_.cycles();
    const int all = scene.width * scene.height;
    std::vector<std::uint64_t> pixel_at(scene.grey.size());
    int at = 0;
    int grey_at = 0;
    int ended = 0;
    bool offered = false;
    while (core_.cycles() - begin < static_cast<std::uint64_t>(all) * 20 && ended < frames) {
      offered = offered || (at < all * frames && sends());
      core_->in_valid = offered;
      core_->in_sof = at % all == 0;
      core_->in_data = scene.grey[static_cast<std::size_t>(at % all)];
      core_->grey_ready = 1;
      // A row can be read once all of it has come out.
      core_.settle();
      core_->read_ready = core_->read_valid &&
                          (static_cast<int>(core_->read_y) + 1) * scene.width <= grey_at - ended * all &&
                          answers();
      core_->answer_valid = !due.empty() && due.front().due <= core_.cycles();
      if (core_->answer_valid) core_->answer = due.front().level;
      core_->marker_ready = answers();
      core_.settle();
      if (core_->answer_valid) due.pop_front();
      if (core_->in_valid && core_->in_ready) {
        // The first few only fill the threshold core.
        if (at == all + in_threshold) result.pace = core_.cycles() - begin - in_threshold;
        if (at < all) pixel_at[static_cast<std::size_t>(at)] = core_.cycles();
        offered = false;
        ++at;
      }
      if (core_->grey_valid) {
        result.grey_differs |= core_->grey_level != scene.grey[static_cast<std::size_t>(grey_at++ % all)];
      }
      if (core_->read_valid && core_->read_ready) {
        const std::size_t place =
            static_cast<std::size_t>(core_->read_y) * static_cast<std::size_t>(scene.width) + core_->read_x;
        due.push_back({scene.grey[place], core_.cycles() + 1 + static_cast<std::uint64_t>(latency)});
      }
      result.dropped += (core_->count_dropped_full | core_->count_dropped_queue | core_->lost) != 0 ? 1U : 0U;
      result.quads += core_->count_quad;
      result.runs += core_->count_run;
      if (core_->marker_valid && core_->marker_ready) {
        if (core_->marker_end) {
          if (ended++ == 0) result.cycles = core_.cycles() + 1 - begin;
        } else if (ended == 0) {
          add(found, pixel_at, scene.width, result);
        }
      }
      core_.tick();
    }
    result.ended = ended == frames;
    result.record_peak = core_->record_peak;
    result.end_peak = core_->end_peak;
    result.markers.assign(found.all().begin(), found.all().end());
    return result;
  }

 private:
  void set(const runmark_settings& s) {
    drive(core_->last_x, s.width - 1U);
    drive(core_->last_y, s.height - 1U);
    core_->rgb = 0;
    core_->cases = s.filter;
    core_->eight = (s.control & RUNMARK_CONTROL_EIGHT) != 0;
    core_->give_up = 0;
    core_->patient = 0;
    core_->holes = (s.control & RUNMARK_CONTROL_HOLES) != 0;
    drive(core_->max_turns, s.max_turns);
    drive(core_->min_height, s.min_height);
    drive(core_->min_area, s.min_area);
    drive(core_->max_area, std::min<std::uint64_t>(s.max_area, Cores::areas));
    drive(core_->max_errors, s.max_errors);
    Cores::set(*core_.operator->(), s);
  }

  void add(FoundMarkers& found, const std::vector<std::uint64_t>& pixel_at, int width, CoresOutcome& result) {
    runmark_record record{};
    record.id = static_cast<std::uint16_t>(core_->marker_id);
    record.errors = core_->marker_errors;
    record.inverted = core_->marker_hole;
    Cores::place(*core_.operator->(), record);
    const Marker marker = marker_of(record);
    double right = 0;
    for (const Point& corner : marker.corners) right = std::max(right, corner.x);
    // The chain closed on this crack line: the last dark row is the one above.
    const std::size_t row =
        static_cast<std::size_t>(core_->marker_bottom - 1) * static_cast<std::size_t>(width);
    const auto last = row + static_cast<std::size_t>(std::min(right, width - 1.0));
    result.latest = std::max(result.latest, core_.cycles() - pixel_at[last]);
    if (found.has(marker.corners)) return;
    result.list_full |= !found.add(marker);
  }

  Dictionary dictionary_;
  Clocked<typename Cores::Model> core_;
};

}  // namespace runmark::rtl
