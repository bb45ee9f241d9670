#include "pipeline/paper_pipeline.h"

#include <algorithm>
#include <cstddef>

#include "corner/corner_state_machine.h"
#include "pattern/square_grid.h"
#include "pipeline/found_markers.h"
#include "threshold/grey_fast.h"

namespace runmark {
namespace {

constexpr int data_side = grid_side - 2;

/// The codes as templates of the whole 8x8 grid: the black border is 0.
Dictionary whole_grid(const Dictionary& dictionary) {
  Dictionary grid = dictionary;
  grid.border = Border::included;
  grid.cells.clear();
  for (int y = 0; y < grid_side; ++y) {
    for (int x = 0; x < grid_side; ++x)
      grid.cells.push_back({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y)});
  }
  if (dictionary.border == Border::included) return grid;
  for (std::uint64_t& code : grid.codes) {
    std::uint64_t whole = 0;
    for (int y = 0; y < data_side; ++y) {
      const std::uint64_t row = code >> (data_side * (data_side - 1 - y)) & ((1U << data_side) - 1);
      whole |= row << (grid_side * (grid_side - 2 - y) + 1);
    }
    code = whole;
  }
  return grid;
}

}  // namespace

PaperPipeline::PaperPipeline(const Options& options, const std::vector<Dictionary>& dictionaries,
                             std::size_t records)
    : options_(options),
      threshold_{options.fixed_threshold, options.above_is_dark},
      grey_(static_cast<std::size_t>(options.max_width)),
      scan_(options.max_width, contour_rules(options, records)) {
  for (const Dictionary& dictionary : dictionaries) {
    const int bits = options.corrected_bits < 0 ? dictionary.corrected_bits : options.corrected_bits;
    templates_.push_back({&dictionary, CodeLookup(whole_grid(dictionary), bits)});
  }
}

ContourRules PaperPipeline::contour_rules(const Options& options, std::size_t records) {
  ContourRules rules;
  rules.preprocess.filter_cases = or_own(options.filter, filter_all);
  rules.preprocess.connectivity = or_own(options.connectivity, Connectivity::eight);
  rules.chains.holes = options.inverted;
  rules.chains.min_height = static_cast<std::uint16_t>(std::min(options.min_marker_size / 2, 65535.0));
  rules.records = records;
  return rules;
}

bool PaperPipeline::can_read(const Dictionary& dictionary) {
  const bool in_border =
      dictionary.border == Border::black && dictionary.cells.size() == data_side * data_side;
  const bool whole =
      dictionary.border == Border::included && dictionary.cells.size() == grid_side * grid_side;
  return dictionary.width == grid_side && (in_border || whole);
}

void PaperPipeline::begin_frame(int width, int height) {
  height_ = height;
  scan_.begin_frame(width, height);
}

void PaperPipeline::push_row(const GreyFrame& frame, FoundMarkers& found, FrameStats& stats) {
  fast::grey_row(frame.rows[frame.height - 1], frame.width, frame.step, frame.format, grey_.data());
  threshold_row(grey_.data(), frame.width, threshold_, scan_.next_row());
  scan_.advance([&](const ClosedChain& chain) { consider(chain, frame, found, stats); });
}

void PaperPipeline::consider(const ClosedChain& chain, const GreyFrame& frame, FoundMarkers& found,
                             FrameStats& stats) const {
  const auto corners = four_corners(chain, options_.corner_offset);
  if (!corners) return;
  ++stats.quads;
  // A hole is followed the other way round.
  std::array<CrackPoint, 4> clockwise = *corners;
  if (chain.hole) std::reverse(clockwise.begin(), clockwise.end());
  Quad quad;
  for (std::size_t i = 0; i < 4; ++i) quad.corners[i] = {clockwise[i].x - 0.5, clockwise[i].y - 0.5};
  const double least = options_.min_marker_size * options_.min_marker_size;
  const double most = options_.max_marker_size * options_.max_marker_size;
  const double area = area_of(quad.corners);
  if (area < least || area > most || !is_convex_clockwise(quad.corners) || found.has(quad.corners)) return;

  std::uint64_t code = 0;
  for (int row = 0; row < grid_side; ++row) {
    for (int column = 0; column < grid_side; ++column) {
      const PixelPosition p = grid_sample(clockwise[0], clockwise[1], column, row);
      if (p.x < 0 || p.y < 0 || p.x >= frame.width || p.y >= height_) return;
      // The square may reach a little below the rows that have come in.
      const int y = std::min(p.y, frame.height - 1);
      const bool dark = threshold_.dark(static_cast<std::uint8_t>(frame.at(p.x, y)));
      code = (code << 1) | (dark != chain.hole ? 0U : 1U);
    }
  }
  std::optional<Marker> best;
  for (const Templates& templates : templates_) {
    const auto match = templates.lookup.find(code);
    if (!match || (best && match->hamming >= best->hamming)) continue;
    Marker marker;
    marker.dictionary = templates.dictionary->name;
    marker.id = match->id;
    marker.hamming = match->hamming;
    marker.margin = 0.5F;  // bits, not grey levels, are compared
    marker.inverted = chain.hole;
    marker.row = frame.height - 1;
    for (std::size_t i = 0; i < 4; ++i) {
      marker.corners[i] = quad.corners[(i + static_cast<std::size_t>(match->rotation)) % 4];
    }
    best = marker;
  }
  if (!best) return found.reject(quad.corners);
  if (!found.add(*best)) ++stats.dropped_markers;
}

void PaperPipeline::end_frame(FrameStats& stats) { scan_.add_counts(stats); }

std::size_t PaperPipeline::memory() const {
  std::size_t bytes = sizeof(*this) + grey_.size() + scan_.memory();
  for (const Templates& templates : templates_) bytes += templates.lookup.memory();
  return bytes;
}

}  // namespace runmark
