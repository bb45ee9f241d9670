#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "axi_memory.h"
#include "pipeline/hardware_pipeline.h"
#include "pipeline/paper_pipeline.h"
#include "runmark/options.h"
#include "runmark_driver.h"
#include "runmark_registers.h"

namespace runmark::rtl {

/// The defaults of a pipeline for frames of one size.
inline Options options_of(Pipeline pipeline, int width, int height) {
  Options options;
  options.pipeline = pipeline;
  options.max_width = width;
  options.max_height = height;
  return options;
}

/// How many wrong bits are corrected: never so many that two codes could match.
inline int corrected_bits(const Options& options, const Dictionary& dictionary) {
  const int asked = options.corrected_bits < 0 ? dictionary.corrected_bits : options.corrected_bits;
  return std::clamp(asked, 0, std::max(0, (dictionary.distance - 1) / 2));
}

/// What only the paper profile looks at.
inline void set_paper(const Options& options, runmark_settings& settings) {
  // Areas in half pixels; no frame is larger than 2^30 pixels.
  const auto area = [](double side) { return std::min(2 * side * side, 2147483648.0); };
  settings.threshold = static_cast<std::uint16_t>(options.fixed_threshold);
  settings.corner_offset = static_cast<std::uint8_t>(options.corner_offset);
  settings.min_area = static_cast<std::uint32_t>(std::ceil(area(options.min_marker_size)));
  settings.max_area = static_cast<std::uint32_t>(std::floor(area(options.max_marker_size)));
  if (options.above_is_dark) settings.control |= RUNMARK_CONTROL_ABOVE_IS_DARK;
}

/// What only the hardware profile looks at.
inline void set_hardware(const Options& options, const Dictionary& dictionary, runmark_settings& settings) {
  const auto area = [](std::int64_t pixels) {
    return static_cast<std::uint32_t>(std::min<std::int64_t>(pixels, 0xFFFFFFFF));
  };
  const IntegerQuadLimits limits = HardwarePipeline::quad_limits(options);
  settings.min_area = area(limits.min_area);
  settings.max_area = area(limits.max_area);
  settings.min_side = static_cast<std::uint16_t>(limits.min_side);
  settings.min_contrast = static_cast<std::uint8_t>(options.min_contrast);
  settings.min_margin = static_cast<std::uint8_t>(HardwarePipeline::reader_limits(options).min_margin);
  settings.cells = static_cast<std::uint8_t>(dictionary.width);
}

/// What makes the hardware do as the pipeline of these options.
/// @param control  further RUNMARK_CONTROL_ bits
inline runmark_settings settings_of(const Options& options, const Dictionary& dictionary, int width,
                                    int height, std::uint32_t control) {
  const bool hardware = options.pipeline == Pipeline::hardware;
  const ContourRules rules =
      hardware ? HardwarePipeline::contour_rules(options) : PaperPipeline::contour_rules(options);
  runmark_settings settings{};
  settings.width = static_cast<std::uint16_t>(width);
  settings.height = static_cast<std::uint16_t>(height);
  settings.filter = rules.preprocess.filter_cases;
  settings.max_turns = static_cast<std::uint8_t>(rules.chains.max_turns);
  settings.min_height = rules.chains.min_height;
  settings.max_errors = static_cast<std::uint8_t>(corrected_bits(options, dictionary));
  settings.control = control;
  if (rules.preprocess.connectivity == Connectivity::eight) settings.control |= RUNMARK_CONTROL_EIGHT;
  if (rules.chains.holes) settings.control |= RUNMARK_CONTROL_HOLES;
  settings.frame_address = AxiMemory::base;
  if (hardware) {
    set_hardware(options, dictionary, settings);
  } else {
    set_paper(options, settings);
  }
  return settings;
}

/// A marker record as the detector would give it; without its dictionary and row.
inline Marker marker_of(const runmark_record& record) {
  Marker marker;
  marker.id = record.id;
  marker.hamming = record.errors;
  marker.inverted = record.inverted != 0;
  const bool fine = record.fine != 0;
  marker.margin = fine ? static_cast<float>(record.clearance) / static_cast<float>(record.scale) : 0.5F;
  for (std::size_t i = 0; i < 4; ++i) {
    marker.corners[i] =
        fine ? in_pixels({record.x[i], record.y[i]}) : Point{record.x[i] - 0.5, record.y[i] - 0.5};
  }
  return marker;
}

}  // namespace runmark::rtl
