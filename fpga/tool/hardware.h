#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "runmark/detector.h"

namespace runmark::rtl {

/// What the hardware made of one picture.
struct HardwareFrame {
  std::vector<Marker> markers;
  /// For each marker, clocks from the pixel at its lowest corner to the last word of its report.
  std::vector<std::uint64_t> latencies;
  std::uint64_t clocks = 0;  ///< from the first pixel to the last word of the frame's end
  unsigned records = 0;      ///< there are
  unsigned record_peak = 0;
  unsigned ends = 0;  ///< there are
  unsigned end_peak = 0;
  std::uint32_t dropped_full = 0;
  std::uint32_t dropped_rule = 0;
  std::uint32_t dropped_queue = 0;
  bool lost = false;
};

/// The world round the core.
struct HardwareSettings {
  Options options;
  Dictionary dictionary;
  bool give_up = false;     ///< as a camera that cannot wait needs it
  int memory_latency = 20;  ///< clocks
  std::string trace;        ///< FST file, or empty
};

/// The translated runmark_top, driven through its registers and streams.
class Hardware {
 public:
  Hardware() = default;
  Hardware(const Hardware&) = delete;
  Hardware& operator=(const Hardware&) = delete;
  virtual ~Hardware() = default;

  /// `pixels` is 8-bit grey or BGR. Throws std::runtime_error when the core refuses or stands still.
  [[nodiscard]] virtual HardwareFrame run(const cv::Mat& pixels) = 0;
};

inline constexpr int most_width = 3840;
inline constexpr int most_height = 2160;

/// The smallest core built that takes such pictures: 640x480 with 1,023 records, or 3840x2160 with 4,095;
/// twice the records in the hardware profile.
[[nodiscard]] std::unique_ptr<Hardware> make_hardware(const HardwareSettings& settings, int width,
                                                      int height);

}  // namespace runmark::rtl
