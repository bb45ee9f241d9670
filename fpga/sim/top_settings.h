#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "axi_memory.h"
#include "pipeline/pipeline.h"
#include "runmark/options.h"
#include "runmark_driver.h"
#include "runmark_registers.h"

namespace runmark::rtl {

/// How many wrong bits the paper pipeline corrects: never so many that two codes could match.
inline int corrected_bits(const Options& options, const Dictionary& dictionary) {
  const int asked = options.corrected_bits < 0 ? dictionary.corrected_bits : options.corrected_bits;
  return std::clamp(asked, 0, std::max(0, (dictionary.distance - 1) / 2));
}

/// What makes the hardware do as `--pipeline paper` with these options.
/// @param control  further RUNMARK_CONTROL_ bits
inline runmark_settings settings_of(const Options& options, const Dictionary& dictionary, int width,
                                    int height, std::uint32_t control) {
  // Areas in half pixels; no frame is larger than 2^30 pixels.
  const auto area = [](double side) { return std::min(2 * side * side, 2147483648.0); };
  runmark_settings settings{};
  settings.width = static_cast<std::uint16_t>(width);
  settings.height = static_cast<std::uint16_t>(height);
  settings.threshold = static_cast<std::uint16_t>(options.fixed_threshold);
  settings.filter = or_own(options.filter, filter_all);
  settings.max_turns = 30;
  settings.min_height = static_cast<std::uint16_t>(options.min_marker_size / 2);
  settings.corner_offset = static_cast<std::uint8_t>(options.corner_offset);
  settings.max_errors = static_cast<std::uint8_t>(corrected_bits(options, dictionary));
  settings.min_area = static_cast<std::uint32_t>(std::ceil(area(options.min_marker_size)));
  settings.max_area = static_cast<std::uint32_t>(std::floor(area(options.max_marker_size)));
  settings.control = control;
  if (or_own(options.connectivity, Connectivity::eight) == Connectivity::eight)
    settings.control |= RUNMARK_CONTROL_EIGHT;
  if (options.above_is_dark) settings.control |= RUNMARK_CONTROL_ABOVE_IS_DARK;
  if (options.inverted) settings.control |= RUNMARK_CONTROL_HOLES;
  settings.frame_address = AxiMemory::base;
  return settings;
}

/// A marker record as the detector would give it; without its dictionary and row.
inline Marker marker_of(const runmark_record& record) {
  Marker marker;
  marker.id = record.id;
  marker.hamming = record.errors;
  marker.margin = 0.5F;
  marker.inverted = record.inverted != 0;
  for (std::size_t i = 0; i < 4; ++i) marker.corners[i] = {record.x[i] - 0.5, record.y[i] - 0.5};
  return marker;
}

}  // namespace runmark::rtl
