#include "pipeline/scale_rules.h"

#include <algorithm>
#include <cmath>

#include "pipeline/pipeline.h"

namespace runmark {
namespace {

constexpr int least_side = 16;      // pixels of a scale worth looking at
constexpr double coarse_size = 14;  // least marker size at a half scale: smaller ones show at full size

// At full size the level lies a little towards white, so that thin dark borders hold together; at the half
// sizes towards black, so that markers that touch at a corner, where blur makes a mid-grey saddle, part.
constexpr int full_size_share = 9;
constexpr int half_size_share = 6;

}  // namespace

ScaleRules scale_rules(const Options& options, int level, bool holes) {
  const double scale = std::ldexp(1.0, level);
  const double size = std::max(options.min_marker_size / scale, level == 0 ? 0.0 : coarse_size);
  ScaleRules rules;
  rules.tiles = {options.min_contrast, level == 0 ? full_size_share : half_size_share,
                 std::max(options.min_contrast * 2 / 5, 1)};
  rules.contours.preprocess.filter_cases = or_own(options.filter, filter_none);
  rules.contours.preprocess.connectivity = or_own(options.connectivity, Connectivity::four);
  rules.contours.chains.holes = holes;
  rules.contours.chains.min_height = static_cast<std::uint16_t>(std::min(size / 2, 65535.0));
  // Cleaned rows come one later: at the half sizes a marker would wait too long for so few specks.
  rules.contours.preprocess.drop_specks = level == 0 && rules.contours.chains.min_height > 1;
  rules.quads.min_area = size * size * 0.8;  // the threshold may shrink a small square
  rules.quads.max_area = options.max_marker_size / scale * (options.max_marker_size / scale) * 1.2;
  rules.quads.min_side = size / 3;
  const int width = std::max(options.max_width >> level, 1);
  rules.contours.records = static_cast<std::size_t>(std::clamp(8 * width, 4096, 65535));
  return rules;
}

bool scale_is_used(int level, int width, int height) {
  return level == 0 || std::min(width, height) >= least_side;
}

}  // namespace runmark
