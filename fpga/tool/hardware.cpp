#include "hardware.h"

#include <verilated_fst_c.h>

#include <fstream>
#include <stdexcept>

#include "Vrunmark_top.h"
#include "Vrunmark_top_4k.h"
#include "Vrunmark_top_hardware.h"
#include "Vrunmark_top_hardware_4k.h"
#include "pipeline/found_markers.h"
#include "top_bench.h"
#include "top_settings.h"

namespace runmark::rtl {
namespace {

std::vector<VideoBeat> video_of(const cv::Mat& pixels) {
  std::vector<VideoBeat> beats;
  beats.reserve(pixels.total());
  for (int y = 0; y < pixels.rows; ++y) {
    const std::uint8_t* row = pixels.ptr(y);
    for (int x = 0; x < pixels.cols; ++x) {
      const std::uint8_t* bgr = row + static_cast<std::ptrdiff_t>(x) * pixels.channels();
      const std::uint32_t data =
          pixels.channels() == 1 ? bgr[0] : bgr[2] | std::uint32_t{bgr[1]} << 8 | std::uint32_t{bgr[0]} << 16;
      beats.push_back({data, x == 0 && y == 0, x == pixels.cols - 1});
    }
  }
  return beats;
}

template <class Model>
class TranslatedHardware final : public Hardware {
 public:
  TranslatedHardware(const HardwareSettings& settings, std::size_t memory_bytes)
      : settings_(settings),
        bench_({100, 100, settings.memory_latency, 100, 100, 0}, memory_bytes, !settings.trace.empty()),
        found_(1000) {
    if (!settings.trace.empty()) open_trace();
  }
  ~TranslatedHardware() override {
    if (wave_) wave_->close();
  }

  HardwareFrame run(const cv::Mat& pixels) override {
    configure(pixels);
    const Counters before = counters();
    bench_.taken_at().clear();
    bench_.send(video_of(pixels));
    found_.begin_frame({0, 0});
    HardwareFrame frame;
    const auto patience = static_cast<std::uint64_t>(pixels.total()) * 50 + 10000000;
    for (const std::uint64_t until = bench_.cycles() + patience;;) {
      if (bench_.cycles() > until) throw std::runtime_error("the hardware stands still");
      bench_.tick();
      const auto taken = bench_.take_record();
      if (taken && add_record(*taken, pixels.cols, frame)) break;
    }
    const Counters after = counters();
    frame.dropped_full = after.full - before.full;
    frame.dropped_rule = after.rule - before.rule;
    frame.dropped_queue = after.queue - before.queue;
    if (!bench_.faults().empty()) throw std::runtime_error("the bus is misused: " + bench_.faults().front());
    frame.markers.assign(found_.all().begin(), found_.all().end());
    return frame;
  }

 private:
  struct Counters {
    std::uint32_t full = 0;
    std::uint32_t rule = 0;
    std::uint32_t queue = 0;
  };
  Counters counters() {
    return {bench_.read_register(RUNMARK_DROPPED_FULL), bench_.read_register(RUNMARK_DROPPED_RULE),
            bench_.read_register(RUNMARK_DROPPED_QUEUE)};
  }

  void open_trace() {
    if (!std::ofstream(settings_.trace)) throw std::runtime_error(settings_.trace + ": cannot be written");
    wave_ = std::make_unique<VerilatedFstC>();
    bench_.clocked()->trace(wave_.get(), 99);
    wave_->open(settings_.trace.c_str());
    bench_.clocked().at_edge([this](std::uint64_t time) { wave_->dump(time); });
  }

  void configure(const cv::Mat& pixels) {
    std::uint32_t control = settings_.give_up ? RUNMARK_CONTROL_GIVE_UP : 0U;
    if (pixels.channels() == 3) control |= RUNMARK_CONTROL_RGB;
    const runmark_settings s =
        settings_of(settings_.options, settings_.dictionary, pixels.cols, pixels.rows, control);
    const auto& codes = settings_.dictionary.codes;
    const auto count = static_cast<unsigned>(codes.size());
    runmark_status status = runmark_configure(&bench_.device(), &s);
    if (status == RUNMARK_OK) status = runmark_load_codes(&bench_.device(), codes.data(), count);
    if (status == RUNMARK_TOO_MANY_CODES) {
      throw std::runtime_error(settings_.dictionary.name + ": " + std::to_string(count) +
                               " codes are more than the hardware holds");
    }
    if (status != RUNMARK_OK) throw std::runtime_error("the hardware refuses these settings");
    runmark_run(&bench_.device(), 1);
  }

  /// True at the end of the frame.
  bool add_record(const StreamedRecord& taken, int width, HardwareFrame& frame) {
    const runmark_record& record = taken.record;
    if (record.end_of_frame != 0) {
      frame.clocks = taken.cycle - bench_.taken_at().front() + 1;
      const std::uint32_t capacity = bench_.read_register(RUNMARK_CAPACITY);
      frame.records = capacity >> RUNMARK_CAPACITY_RECORDS_SHIFT & RUNMARK_CAPACITY_RECORDS_MASK;
      frame.ends = bench_.read_register(RUNMARK_LARGEST) & RUNMARK_LARGEST_WIDTH_MASK;
      frame.record_peak = record.record_peak;
      frame.end_peak = record.end_peak;
      frame.lost = record.lost != 0;
      return true;
    }
    Marker marker = marker_of(record);
    if (found_.has(marker.corners)) return false;
    marker.dictionary = settings_.dictionary.name;
    if (!found_.add(marker)) return false;
    const auto lowest = std::max_element(record.y, record.y + 4) - record.y;
    const int x = record.fine != 0 ? record.x[lowest] / 16 : record.x[lowest] - 1;
    const std::size_t last = (record.bottom - 1U) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(std::clamp(x, 0, width - 1));
    frame.latencies.push_back(taken.cycle - bench_.taken_at()[last]);
    return false;
  }

  HardwareSettings settings_;
  std::unique_ptr<VerilatedFstC> wave_;
  TopBench<Model> bench_;
  FoundMarkers found_;
};

}  // namespace

std::unique_ptr<Hardware> make_hardware(const HardwareSettings& settings, int width, int height) {
  // Two frames, their sides rounded up to powers of two.
  constexpr std::size_t small = std::size_t{1} << 20;
  constexpr std::size_t large = std::size_t{1} << 25;
  const bool fits = width <= 640 && height <= 480;
  if (settings.options.pipeline == Pipeline::hardware) {
    if (fits) return std::make_unique<TranslatedHardware<Vrunmark_top_hardware>>(settings, small);
    return std::make_unique<TranslatedHardware<Vrunmark_top_hardware_4k>>(settings, large);
  }
  if (fits) return std::make_unique<TranslatedHardware<Vrunmark_top>>(settings, small);
  return std::make_unique<TranslatedHardware<Vrunmark_top_4k>>(settings, large);
}

}  // namespace runmark::rtl
