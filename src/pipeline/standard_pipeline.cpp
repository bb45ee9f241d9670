#include "pipeline/standard_pipeline.h"

#include <algorithm>
#include <cmath>

#include "pattern/edge_refine.h"
#include "pipeline/found_markers.h"
#include "pipeline/halve_fast.h"
#include "pipeline/scale_rules.h"
#include "threshold/grey_fast.h"

namespace runmark {
namespace {

constexpr int rows_kept = 9;               // two bands of tiles and the row being made
constexpr std::size_t most_waiting = 256;  // quadrilaterals; further ones are read at once

}  // namespace

StandardPipeline::StandardPipeline(const Options& options, const std::vector<Dictionary>& dictionaries)
    : options_(options),
      reader_(dictionaries, {options.corrected_bits, options.min_margin, options.inverted}),
      outline_(max_vertices(ChainLimits{})) {
  for (int level = 0; level <= options.octaves; ++level) {
    const int width = std::max(options.max_width >> level, 1);
    const ScaleRules rules = scale_rules(options, level, reader_.reads(true));
    scales_.push_back({Octave(width, rules.contours), RowStore(width, rows_kept), rules.tiles, rules.quads});
  }
  waiting_.reserve(most_waiting);
}

void StandardPipeline::begin_frame(int width, int height) {
  height_ = height;
  waiting_.clear();
  scales_used_ = 0;
  for (Scale& scale : scales_) {
    if (!scale_is_used(static_cast<int>(scales_used_), width, height)) break;
    scale.octave.begin_frame(width, height, scale.tiles);
    ++scales_used_;
    width /= 2;
    height /= 2;
  }
}

void StandardPipeline::push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) {
  const int y = frame.height - 1;
  const std::uint8_t* grey = frame.rows[y];
  if (frame.format != PixelFormat::grey || frame.step != 1) {
    std::uint8_t* converted = scales_[0].rows.row(y);
    fast::grey_row(grey, frame.width, frame.step, frame.format, converted);
    grey = converted;
  }
  push_scaled(0, grey, y, frame, found, stats);
  if (waiting_.empty()) return;
  const auto ready = [&](const Waiting& w) { return w.row <= y || y + 1 == height_; };
  for (const Waiting& w : waiting_) {
    if (ready(w)) read(w.quad, w.reach, frame, found, stats);
  }
  std::erase_if(waiting_, ready);
}

void StandardPipeline::push_scaled(std::size_t level, const std::uint8_t* grey, int y, const GreyFrame& frame,
                                   FoundMarkers& found, FrameStats& stats) {
  Scale& scale = scales_[level];
  scale.octave.push(grey, [&](const ClosedChain& chain) { consider(level, chain, frame, found, stats); });
  if (level + 1 == scales_used_) return;
  // Halve every second row with the one before it.
  if (y % 2 == 0) return;
  Scale& next = scales_[level + 1];
  const int half_y = y / 2;
  if (half_y >= next.octave.height()) return;
  const bool whole_frame = level == 0 && frame.format == PixelFormat::grey && frame.step == 1;
  const std::uint8_t* upper = whole_frame ? frame.rows[y - 1] : scale.rows.row(y - 1);
  std::uint8_t* half = next.rows.row(half_y);
  fast::halve_rows(upper, grey, next.octave.width(), half);
  push_scaled(level + 1, half, half_y, frame, found, stats);
}

void StandardPipeline::consider(std::size_t level, const ClosedChain& chain, const GreyFrame& frame,
                                FoundMarkers& found, FrameStats& stats) {
  if (!reader_.reads(chain.hole)) return;
  std::optional<Quad> quad = quad_from_chain(chain, scales_[level].limits, outline_);
  if (!quad) return;
  ++stats.quads;
  const double scale = std::ldexp(1.0, static_cast<int>(level));
  for (Point& corner : quad->corners) {
    corner = {corner.x * scale + (scale - 1) / 2, corner.y * scale + (scale - 1) / 2};
  }
  const double reach = 2.5 * scale;
  const int lowest = reader_.lowest_row(*quad);
  if (lowest >= frame.height && frame.height < height_ && waiting_.size() < most_waiting) {
    waiting_.push_back({*quad, reach, lowest});
  } else {
    read(*quad, reach, frame, found, stats);
  }
}

void StandardPipeline::read(const Quad& quad, double reach, const GreyFrame& frame, FoundMarkers& found,
                            FrameStats& stats) const {
  if (found.has(quad.corners)) return;
  std::optional<Marker> marker;
  if (reader_.may_be_marker(frame, quad)) {
    const Quad refined = refine_edges(frame, quad, reader_.most_cells(), reach);
    marker = reader_.read(frame, refined);
    // A stronger edge beside it may have drawn a side away from the outline.
    const bool moved = std::isfinite(refined.blur);
    if (!marker && moved) marker = reader_.read_again(frame, quad);
  }
  if (!marker) return found.reject(quad.corners);
  marker->row = frame.height - 1;
  if (!found.add(*marker)) ++stats.dropped_markers;
}

void StandardPipeline::end_frame(FrameStats& stats) {
  for (std::size_t level = 0; level < scales_used_; ++level) scales_[level].octave.add_counts(stats);
}

std::size_t StandardPipeline::memory() const {
  std::size_t bytes = sizeof(*this) + reader_.memory() + 2 * outline_.x.size() * sizeof(float) +
                      most_waiting * sizeof(Waiting);
  for (const Scale& scale : scales_) bytes += scale.octave.memory() + scale.rows.memory();
  return bytes;
}

}  // namespace runmark
