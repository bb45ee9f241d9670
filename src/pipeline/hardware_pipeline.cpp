#include "pipeline/hardware_pipeline.h"

#include <algorithm>
#include <cmath>

#include "pipeline/found_markers.h"
#include "threshold/grey.h"

namespace runmark {

HardwarePipeline::HardwarePipeline(const Options& options, const std::vector<Dictionary>& dictionaries,
                                   std::size_t records)
    : options_(options),
      limits_(quad_limits(options)),
      tiles_(options.max_width),
      grey_(options.max_width, 2 * IntegerTiles::side),
      scan_(options.max_width, contour_rules(options, records)),
      reader_(dictionaries, reader_limits(options)) {}

ContourRules HardwarePipeline::contour_rules(const Options& options, std::size_t records) {
  ContourRules rules;
  rules.preprocess.filter_cases = or_own(options.filter, filter_none);
  rules.preprocess.connectivity = or_own(options.connectivity, Connectivity::four);
  rules.chains.holes = options.inverted;
  rules.chains.min_height = static_cast<std::uint16_t>(std::min(options.min_marker_size / 2, 65535.0));
  rules.chains.max_records = 65535;
  rules.records = records;
  return rules;
}

IntegerQuadLimits HardwarePipeline::quad_limits(const Options& options) {
  const auto square = [](double size) { return static_cast<std::int64_t>(size * size); };
  IntegerQuadLimits limits;
  limits.min_area =
      square(std::min(options.min_marker_size, 65535.0)) * 4 / 5;  // the threshold may shrink a small square
  limits.max_area = square(std::min(options.max_marker_size, 65535.0)) * 6 / 5;
  limits.min_side = static_cast<int>(std::min(options.min_marker_size, 65535.0)) / 3;
  return limits;
}

IntegerReaderLimits HardwarePipeline::reader_limits(const Options& options) {
  return {options.corrected_bits, static_cast<int>(std::lround(options.min_margin * 256))};
}

void HardwarePipeline::begin_frame(int width, int height) {
  height_ = height;
  tiles_.begin_frame(width, height, options_.min_contrast);
  scan_.begin_frame(width, height);
}

void HardwarePipeline::push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) {
  const int y = frame.height - 1;
  std::uint8_t* grey = grey_.row(y);
  grey_row(frame.rows[y], frame.width, frame.step, frame.format, grey);
  if (!tiles_.add_row(grey)) return;
  follow(frame, found, stats);
  if (frame.height < height_) return;
  tiles_.finish();
  follow(frame, found, stats);
}

void HardwarePipeline::follow(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) {
  for (int y = tiles_.ready_from(); y < tiles_.ready_to(); ++y) {
    tiles_.threshold(grey_.row(y), scan_.next_row());
    scan_.advance([&](const ClosedChain& chain) { consider(chain, frame, found, stats); });
  }
}

void HardwarePipeline::consider(const ClosedChain& chain, const GreyFrame& frame, FoundMarkers& found,
                                FrameStats& stats) const {
  const auto quad = integer_quad(chain, limits_);
  if (!quad) return;
  ++stats.quads;
  // The rows that are in for certain when this chain closes, whichever the phase of the bands.
  const int last_row = std::min(chain.bottom + IntegerTiles::side, height_ - 1);
  const auto reading = reader_.read(frame, last_row, *quad);

  // Everything above is integers; from here on they are only written down in another way.
  const auto rotation = static_cast<std::size_t>(reading ? reading->match.rotation : 0);
  std::array<Point, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = in_pixels(quad->corners[(i + rotation) % 4]);
  if (!reading) return found.reject(corners);
  if (found.has(corners)) return;
  Marker marker;
  marker.dictionary = reading->dictionary->name;
  marker.id = reading->match.id;
  marker.corners = corners;
  marker.hamming = reading->match.hamming;
  marker.margin = static_cast<float>(reading->clearance) / static_cast<float>(reading->scale);
  marker.inverted = chain.hole;
  marker.row = frame.height - 1;
  if (!found.add(marker)) ++stats.dropped_markers;
}

void HardwarePipeline::end_frame(FrameStats& stats) { scan_.add_counts(stats); }

std::size_t HardwarePipeline::memory() const {
  return sizeof(*this) + tiles_.memory() + grey_.memory() + scan_.memory() + reader_.memory();
}

}  // namespace runmark
