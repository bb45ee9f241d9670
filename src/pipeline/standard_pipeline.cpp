#include "pipeline/standard_pipeline.h"

#include <algorithm>
#include <cmath>

#include "pattern/edge_refine.h"
#include "pipeline/found_markers.h"
#include "pipeline/halve.h"

namespace runmark {
namespace {

constexpr int least_side = 16;             // pixels of a scale worth looking at
constexpr int rows_kept = 9;               // two bands of tiles and the row being made
constexpr std::size_t most_waiting = 256;  // quadrilaterals; further ones are read at once
constexpr double coarse_size = 14;  // least marker size at a half scale: smaller ones show at full size

// At full size the level lies a little towards white, so that thin dark borders hold together; at the half
// sizes towards black, so that markers that touch at a corner, where blur makes a mid-grey saddle, part.
constexpr int full_size_share = 9;
constexpr int half_size_share = 6;

std::size_t records_for(int width) { return static_cast<std::size_t>(std::clamp(8 * width, 4096, 65535)); }

}  // namespace

StandardPipeline::StandardPipeline(const Options& options, const std::vector<Dictionary>& dictionaries)
    : options_(options),
      reader_(dictionaries, {options.corrected_bits, options.min_margin, options.inverted}) {
  ChainLimits chain_limits;
  chain_limits.holes = reader_.reads(true);
  for (int level = 0; level <= options.octaves; ++level) {
    const int width = std::max(options.max_width >> level, 1);
    const double scale = std::ldexp(1.0, level);
    const double size = std::max(options.min_marker_size / scale, level == 0 ? 0.0 : coarse_size);
    QuadLimits limits;
    limits.min_area = size * size * 0.8;  // the threshold may shrink a small square
    limits.max_area = options.max_marker_size / scale * (options.max_marker_size / scale) * 1.2;
    limits.min_side = size / 3;
    chain_limits.min_height = static_cast<std::uint16_t>(size / 2);
    scales_.push_back(
        {Octave(width, records_for(width), chain_limits, or_own(options.connectivity, Connectivity::four),
                or_own(options.filter, filter_none)),
         RowStore(width, rows_kept), limits});
  }
  vertices_.resize(max_vertices(chain_limits));
  waiting_.reserve(most_waiting);
}

void StandardPipeline::begin_frame(int width, int height) {
  height_ = height;
  waiting_.clear();
  scales_used_ = 0;
  for (Scale& scale : scales_) {
    if (scales_used_ > 0 && std::min(width, height) < least_side) break;
    const int share = scales_used_ == 0 ? full_size_share : half_size_share;
    scale.octave.begin_frame(width, height, {options_.min_contrast, share});
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
    grey_row(grey, frame.width, frame.step, frame.format, converted);
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
  halve_rows(upper, grey, next.octave.width(), half);
  push_scaled(level + 1, half, half_y, frame, found, stats);
}

void StandardPipeline::consider(std::size_t level, const ClosedChain& chain, const GreyFrame& frame,
                                FoundMarkers& found, FrameStats& stats) {
  if (!reader_.reads(chain.hole)) return;
  std::optional<Quad> quad = quad_from_chain(chain, scales_[level].limits, vertices_);
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
  if (found.has(quad.corners) || !reader_.has_border(frame, quad)) return;
  std::optional<Marker> marker = reader_.read(frame, refine_edges(frame, quad, reader_.most_cells(), reach));
  if (!marker) return;
  marker->row = frame.height - 1;
  if (!found.add(*marker)) ++stats.dropped_markers;
}

void StandardPipeline::end_frame(FrameStats& stats) {
  for (std::size_t level = 0; level < scales_used_; ++level) {
    const Octave& octave = scales_[level].octave;
    const LinkerCounts& counts = octave.linker().counts();
    stats.pixels += static_cast<std::uint64_t>(octave.width()) * static_cast<std::uint64_t>(octave.height());
    stats.crack_runs += counts.runs;
    stats.closed_chains += counts.closed;
    stats.dropped_chains += counts.dropped_full;
    stats.records_peak = std::max<std::uint64_t>(stats.records_peak, octave.linker().pool().peak());
  }
}

std::size_t StandardPipeline::memory() const {
  std::size_t bytes =
      sizeof(*this) + reader_.memory() + vertices_.size() * sizeof(Vertex) + most_waiting * sizeof(Waiting);
  for (const Scale& scale : scales_) bytes += scale.octave.memory() + scale.rows.memory();
  return bytes;
}

}  // namespace runmark
